// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/records.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/data/log_channels.h"
#include "fathom/diagnosis/data/log_names.h"
#include "fathom/diagnosis/data/uneven_noise.h"
#include "fathom/signal/log_column.h"
#include "fathom/signal/split_at_gaps.h"
#include "fathom/simulate/effect_inputs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr size_t kFewestSamples = 20;  // of a record's leading channel
constexpr double kStartWindow = 2.0;   // [s] of samples behind the guess of the start

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

// The samples from `from` to `to` [s], both included.
SampledSignal Between(const SampledSignal& channel, double from, double to) {
  const auto begin = std::lower_bound(channel.time.begin(), channel.time.end(), from);
  const auto end = std::upper_bound(channel.time.begin(), channel.time.end(), to);
  const auto offset = begin - channel.time.begin();
  return {{begin, end},
          {channel.value.begin() + offset, channel.value.begin() + (end - channel.time.begin())}};
}

// The way from sample `first` on to each sample, along the measured velocity.
std::vector<double> WayAlong(const SampledSignal& velocity, size_t first) {
  const auto& [time, value] = velocity;
  std::vector<double> way(time.size(), 0.0);
  for (size_t i = first + 1; i < time.size(); ++i) {
    way[i] = way[i - 1] + 0.5 * (time[i] - time[i - 1]) * (value[i - 1] + value[i]);
  }
  return way;
}

// A record of what all logs measure, from `from` to `to` [s]. `position`: where it starts if
// nothing measures that.
Record RecordBetween(
    double from, double to, double position, const LogChannels& channels, const Records& records) {
  Record record;
  record.log = channels.name;
  record.stamps.start = from;
  record.initial.position = position;
  if (records.has_velocity) {
    SampledSignal part = Between(*channels.velocity, from, to);
    record.stamps.velocity = std::move(part.time);
    record.velocity = std::move(part.value);
  }
  if (records.has_displacement) {
    SampledSignal part = Between(*channels.displacement, from, to);
    record.stamps.displacement = std::move(part.time);
    record.displacement = std::move(part.value);
    record.displacement_variance =
        VarianceOverUsual(record.stamps.displacement, record.displacement);
  }
  RestartAt(from, &record);
  return record;
}

// Adds the records of one log, cut at silences and at the ends of held-out intervals.
void AddRecordsOf(const LogChannels& channels, Dof dof, Records* records) {
  auto inputs = std::make_shared<EffectInputs>(MeasuredInputsOf(*channels.log, dof));
  inputs->log = channels.name;
  const SampledSignal& leading =
      records->has_velocity ? *channels.velocity : *channels.displacement;
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
  const std::vector<double> way =
      records->has_displacement ? std::vector<double>(time.size(), 0.0) : WayAlong(leading, first);
  const LongRanges kept =
      WithoutShort(SplitAtGaps(time, channels.log->held_out, first), kFewestSamples);
  for (const SampleRange& range : kept.ranges) {
    Record record =
        RecordBetween(time[range.begin], time[range.end - 1], way[range.begin], channels, *records);
    record.is_held_out = range.is_held_out;
    record.inputs = inputs;
    records->all.push_back(std::move(record));
  }
  if (kept.num_short > 0) {
    records->remarks.push_back(
        fmt::format("{}: left out: {} segments of fewer than {} samples ({} samples).",
                    channels.name,
                    kept.num_short,
                    kFewestSamples,
                    kept.num_samples_in_short));
  }
}

// Other DOFs whose velocity is measured, and changes, in every record.
std::vector<Dof> PartnersIn(std::span<const Record> records, Dof dof) {
  std::vector<Dof> partners;
  for (const Dof other : kAllDofs) {
    const bool everywhere =
        other != dof && std::all_of(records.begin(), records.end(), [&](const Record& record) {
          const auto& signal = record.inputs->velocity[Index(other)].value;
          if (signal.empty()) return false;
          const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
          return *most > *least;
        });
    if (everywhere) partners.push_back(other);
  }
  return partners;
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
  const std::vector<LogChannels> channels = ChannelsOf(logs, records.logs, dof);
  records.force_unit = CommandUnitOf(logs.front(), dof);
  records.has_velocity = std::ranges::all_of(
      channels, [](const LogChannels& own) { return own.velocity.has_value(); });
  records.has_displacement = std::ranges::all_of(
      channels, [](const LogChannels& own) { return own.displacement.has_value(); });
  for (const LogChannels& own : channels) {
    records.poses_lose_motion = records.poses_lose_motion || LosesMotion(own);
    records.remarks.insert(records.remarks.end(), own.remarks.begin(), own.remarks.end());
  }
  if (!records.has_velocity && !records.has_displacement) {
    throw InputError(
        "Some of the logs have velocities only and some have poses only: expected "
        "velocities in all of them or poses in all of them.");
  }
  if (records.has_velocity && records.has_displacement && records.poses_lose_motion) {
    records.remarks.push_back(
        "Not tried: pose_scale. The poses themselves may be short of motion, as their remark says: "
        "with several markers, or one seen at an angle, a wrong size can be told.");
  }
  for (const LogChannels& own : channels) AddRecordsOf(own, dof, &records);
  const bool has_train = std::any_of(
      records.all.begin(), records.all.end(), [](const Record& r) { return !r.is_held_out; });
  if (!has_train) {
    throw InputError(
        fmt::format("{}: nothing is left to train on: expected a segment of at least "
                    "{} motion samples after the first command and outside held_out.",
                    logs.front().name,
                    kFewestSamples));
  }
  records.partners = PartnersIn(records.all, dof);
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
