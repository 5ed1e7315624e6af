// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/records.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/data/log_names.h"
#include "fathom/diagnosis/data/pose_coordinate.h"
#include "fathom/diagnosis/data/uneven_noise.h"
#include "fathom/signal/log_column.h"
#include "fathom/simulate/effect_inputs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestGap = 30.0;   // [s], as in SignalsOptions
constexpr size_t kFewestSamples = 20;  // of a record's leading channel
constexpr double kStartWindow = 2.0;   // [s] of samples behind the guess of the start

bool IsHeldOut(const Log& log, double t) {
  return std::any_of(log.held_out.begin(), log.held_out.end(), [t](const TimeInterval& interval) {
    return interval.Contains(t);
  });
}

// Value and slope at the first sample, by a straight line over the first two seconds.
std::pair<double, double> StartOf(std::span<const double> time, std::span<const double> value) {
  double n = 0.0, st = 0.0, sy = 0.0, stt = 0.0, sty = 0.0;
  for (size_t i = 0; i < time.size(); ++i) {
    const double t = time[i] - time[0];
    if (t > kStartWindow && i >= 5) break;
    n += 1.0;
    st += t;
    sy += value[i];
    stt += t * t;
    sty += t * value[i];
  }
  const double slope = (n * sty - st * sy) / std::max(1e-12, n * stt - st * st);
  return {(sy - slope * st) / n, slope};
}

void Append(const SampledSignal& channel, double from, double to, SampledSignal* out) {
  const auto begin = std::lower_bound(channel.time.begin(), channel.time.end(), from);
  const auto end = std::upper_bound(channel.time.begin(), channel.time.end(), to);
  out->time.assign(begin, end);
  const auto offset = begin - channel.time.begin();
  out->value.assign(channel.value.begin() + offset,
                    channel.value.begin() + (end - channel.time.begin()));
}

struct LogChannels {
  const Log* log;
  std::string name;
  std::optional<SampledSignal> velocity, displacement;
};

// The stretches of one log, cut at silences and at the ends of held-out intervals.
void AppendRecords(const LogChannels& channels,
                   Dof dof,
                   bool use_velocity,
                   bool use_displacement,
                   Records* records) {
  const Log& log = *channels.log;
  auto inputs = std::make_shared<EffectInputs>(MeasuredInputsOf(log, dof));
  inputs->log = channels.name;
  const SampledSignal& leading = use_velocity ? *channels.velocity : *channels.displacement;
  const std::vector<double>& time = leading.time;
  const size_t first =
      std::lower_bound(time.begin(), time.end(), inputs->command.time.front()) - time.begin();
  if (first > 0) {
    records->remarks.push_back(fmt::format(
        "{}: left out: {} motion samples before the first command.", channels.name, first));
  }
  if (const auto remark = RemarkOnEarlyEnd(inputs->command, time, kLongestGap); !remark.empty()) {
    records->remarks.push_back(channels.name + ": " + remark);
  }
  // Without poses the position counts from the first sample, along the measured velocity.
  std::vector<double> way(time.size(), 0.0);
  for (size_t i = first + 1; i < time.size() && !use_displacement; ++i) {
    way[i] = way[i - 1] + 0.5 * (time[i] - time[i - 1]) * (leading.value[i - 1] + leading.value[i]);
  }
  size_t num_short = 0, num_short_samples = 0;
  for (size_t begin = first; begin < time.size();) {
    const bool held_out = IsHeldOut(log, time[begin]);
    size_t end = begin + 1;
    while (end < time.size() && time[end] - time[end - 1] <= kLongestGap &&
           IsHeldOut(log, time[end]) == held_out) {
      ++end;
    }
    if (end - begin < kFewestSamples) {
      ++num_short;
      num_short_samples += end - begin;
    } else {
      Record record;
      record.log = channels.name;
      record.is_held_out = held_out;
      record.inputs = inputs;
      record.stamps.start = time[begin];
      record.initial.position = way[begin];
      SampledSignal part;
      if (use_velocity) {
        Append(*channels.velocity, time[begin], time[end - 1], &part);
        record.stamps.velocity = std::move(part.time);
        record.velocity = std::move(part.value);
      }
      if (use_displacement) {
        Append(*channels.displacement, time[begin], time[end - 1], &part);
        record.stamps.displacement = std::move(part.time);
        record.displacement = std::move(part.value);
        record.displacement_variance =
            VarianceOverUsual(record.stamps.displacement, record.displacement);
      }
      RestartAt(time[begin], &record);
      records->all.push_back(std::move(record));
    }
    begin = end;
  }
  if (num_short > 0) {
    records->remarks.push_back(
        fmt::format("{}: left out: {} segments of fewer than {} samples ({} samples).",
                    channels.name,
                    num_short,
                    kFewestSamples,
                    num_short_samples));
  }
}

}  // namespace

double Record::duration() const {
  const double last_velocity = stamps.velocity.empty() ? stamps.start : stamps.velocity.back();
  const double last_pose = stamps.displacement.empty() ? stamps.start : stamps.displacement.back();
  return std::max(last_velocity, last_pose) - stamps.start;
}

Records RecordsOf(std::span<const Log> logs, Dof dof) {
  if (logs.empty()) throw InputError("A diagnosis needs at least one log.");
  Records records;
  records.logs = DistinctNames(logs);
  std::vector<LogChannels> channels;
  bool every_velocity = true, every_displacement = true;
  for (size_t k = 0; k < logs.size(); ++k) {
    const Log& log = logs[k];
    const std::string unit =
        log.command_unit.empty() ? std::string(ForceUnit(dof)) : log.command_unit;
    if (!records.force_unit.empty() && unit != records.force_unit) {
      throw InputError(
          fmt::format("{}: its commands are in {}, those of {} in {}: expected logs of one unit.",
                      records.logs[k],
                      unit,
                      records.logs.front(),
                      records.force_unit));
    }
    records.force_unit = unit;
    LogChannels own = {&log, records.logs[k], std::nullopt, std::nullopt};
    if (log.velocity) {
      if (const auto* column = log.velocity->Find(VelocityColumn(dof))) {
        own.velocity = SampledSignal{log.velocity->time, *column};
      }
    }
    own.displacement = PoseCoordinate(log, own.name, dof, &records.remarks);
    records.poses_lose_motion = records.poses_lose_motion ||
                                (own.displacement && Holds(log.remarks, RemarkKind::kLostMotion));
    if (!own.velocity && !own.displacement) {
      if (log.pose && !log.velocity) throw InputError(records.remarks.back());
      MotionStream(log, dof, Source::kPoseEstimator);
    }
    every_velocity = every_velocity && own.velocity.has_value();
    every_displacement = every_displacement && own.displacement.has_value();
    channels.push_back(std::move(own));
  }
  if (!every_velocity && !every_displacement) {
    throw InputError(
        "Some of the logs have velocities only and some have poses only: expected "
        "velocities in all of them or poses in all of them.");
  }
  records.has_velocity = every_velocity;
  records.has_displacement = every_displacement;
  if (every_velocity && every_displacement && records.poses_lose_motion) {
    records.remarks.push_back(
        "Not tried: pose_scale. The poses themselves may be short of motion, as their remark says: "
        "with several markers, or one seen at an angle, a wrong size can be told.");
  }
  for (const LogChannels& own : channels) {
    AppendRecords(own, dof, every_velocity, every_displacement, &records);
  }
  const bool has_train = std::any_of(
      records.all.begin(), records.all.end(), [](const Record& r) { return !r.is_held_out; });
  if (!has_train) {
    throw InputError(
        fmt::format("{}: nothing is left to train on: expected a segment of at least "
                    "{} motion samples after the first command and outside held_out.",
                    logs.front().name,
                    kFewestSamples));
  }
  for (const Dof other : kAllDofs) {
    const bool everywhere =
        other != dof && std::all_of(records.all.begin(), records.all.end(), [&](const Record& r) {
          const auto& signal = r.inputs->velocity[Index(other)].value;
          if (signal.empty()) return false;
          const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
          return *most > *least;
        });
    if (everywhere) records.partners.push_back(other);
  }
  return records;
}

void RestartAt(double time, Record* record) {
  record->stamps.start = time;
  if (!record->velocity.empty()) {
    record->initial.velocity = StartOf(record->stamps.velocity, record->velocity).first;
  }
  if (record->displacement.size() < 2) return;
  const auto [value, slope] = StartOf(record->stamps.displacement, record->displacement);
  record->initial.position = value - slope * (record->stamps.displacement.front() - time);
  if (record->velocity.empty()) record->initial.velocity = slope;
}

Segment SegmentOfRecord(const Record& record) {
  Segment segment;
  segment.command = record.inputs->command;
  if (!record.velocity.empty()) {
    segment.time = record.stamps.velocity;
    segment.velocity = record.velocity;
  } else {
    segment.time = record.stamps.displacement;
    segment.position = record.displacement;
    // A slope over a second: only the start of a search.
    const size_t n = segment.time.size();
    for (size_t i = 0; i < n; ++i) {
      size_t low = i, high = i;
      while (low > 0 && segment.time[i] - segment.time[low] < 0.5) --low;
      while (high + 1 < n && segment.time[high] - segment.time[i] < 0.5) ++high;
      segment.velocity.push_back((segment.position[high] - segment.position[low]) /
                                 (segment.time[high] - segment.time[low]));
    }
  }
  segment.initial_velocity = record.initial.velocity;
  return segment;
}

}  // namespace fathom
