// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/records.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/log_names.h"
#include "fathom/signal/log_column.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/signal/savitzky_golay.h"
#include "fathom/simulate/effect_inputs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestGap = 30.0;       // [s], as in SignalsOptions
constexpr size_t kFewestSamples = 20;      // of a record's leading channel
constexpr double kLargestAxisTurn = 0.12;  // RMS [rad] at which a world coordinate still serves
constexpr double kSteadyAxis = 0.02;       // RMS [rad] below which it is taken to keep still
constexpr double kLargestLeak = 1.0;       // of the positions' noise: what the turning adds to it
constexpr double kStartWindow = 2.0;       // [s] of samples behind the guess of the start

struct Channel {
  std::vector<double> time, value;
};

bool IsHeldOut(const Log& log, double t) {
  return std::any_of(log.held_out.begin(), log.held_out.end(), [t](const TimeInterval& interval) {
    return interval.Contains(t);
  });
}

// How far the DOF's axis turns about its mean [rad, RMS]; angles have no such axis.
double AxisTurn(Dof dof, const Poses& poses) {
  if (IsAngular(dof)) return 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& rotation : poses.world_from_body) {
    mean += rotation.toRotationMatrix().col(Index(dof));
  }
  mean.normalize();
  double sum = 0.0;
  for (const auto& rotation : poses.world_from_body) {
    const double cosine = rotation.toRotationMatrix().col(Index(dof)).dot(mean);
    sum += 2.0 * (1.0 - cosine);
  }
  return std::sqrt(sum / static_cast<double>(poses.size()));
}

// Poses averaged over about a second, so that their noise does not add up along the way.
Poses SlowPoses(const Poses& poses) {
  Poses slow;
  for (size_t begin = 0; begin < poses.size();) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector4d rotation = Eigen::Vector4d::Zero();
    size_t end = begin;
    for (; end < poses.size() && poses.time[end] - poses.time[begin] < 1.0; ++end) {
      position += poses.position[end];
      const Eigen::Vector4d q = poses.world_from_body[end].coeffs();
      rotation += q.dot(poses.world_from_body[begin].coeffs()) < 0.0 ? Eigen::Vector4d(-q) : q;
    }
    slow.time.push_back(poses.time[begin]);
    slow.position.push_back(position / static_cast<double>(end - begin));
    slow.world_from_body.push_back(Eigen::Quaterniond(rotation).normalized());
    begin = end;
  }
  return slow;
}

// Noise of a coordinate, from its second differences.
double NoiseOf(const std::vector<double>& coordinate) {
  double sum = 0.0;
  for (size_t i = 2; i < coordinate.size(); ++i) {
    const double bend = coordinate[i] - 2.0 * coordinate[i - 1] + coordinate[i - 2];
    sum += bend * bend / 6.0;
  }
  return std::sqrt(sum / static_cast<double>(std::max<size_t>(coordinate.size(), 3) - 2));
}

// By how much the world coordinate differs from the way along the turning axis [RMS]: motion along
// the other axes leaks into a coordinate when the vehicle turns.
double LeakOf(Dof dof, const Poses& poses) {
  const Poses slow = SlowPoses(poses);
  if (AxisTurn(dof, slow) < kSteadyAxis) return 0.0;  // attitude noise alone would add up
  const std::vector<double> coordinate = DisplacementAlong(dof, slow).value;
  std::vector<double> difference = {0.0};
  double way = 0.0;
  for (size_t i = 1; i < slow.size(); ++i) {
    const Eigen::Quaterniond middle =
        slow.world_from_body[i - 1].slerp(0.5, slow.world_from_body[i]);
    way += (middle.conjugate() * (slow.position[i] - slow.position[i - 1]))[Index(dof)];
    difference.push_back(coordinate[i] - coordinate[0] - way);
  }
  const Eigen::Map<const Eigen::ArrayXd> d(difference.data(), std::ssize(difference));
  return std::sqrt((d - d.mean()).square().mean());
}

std::optional<Channel> DisplacementOf(const Log& log,
                                      const std::string& name,
                                      Dof dof,
                                      std::vector<std::string>* remarks) {
  if (!log.pose || log.pose->time.size() < kFewestSamples) return std::nullopt;
  const Poses poses = PosesOf(*log.pose);
  const Displacement displacement = DisplacementAlong(dof, poses);
  const double turn = AxisTurn(dof, poses);
  if (turn > kLargestAxisTurn && log.velocity) {
    remarks->push_back(
        fmt::format("{}: the poses are not used: the {} axis turns by {:.2f} rad RMS, so that no "
                    "world coordinate is its displacement.",
                    name,
                    Name(dof),
                    turn));
    return std::nullopt;
  }
  const double leak = LeakOf(dof, poses) / std::max(NoiseOf(displacement.value), 1e-12);
  if (leak > kLargestLeak && log.velocity) {
    remarks->push_back(
        fmt::format("{}: the poses are not used: the vehicle turns, and what leaks from its other "
                    "motion into the {} coordinate is {:.1f} times the coordinate's noise.",
                    name,
                    Name(dof),
                    leak));
    return std::nullopt;
  }
  return Channel{poses.time, displacement.value};
}

std::shared_ptr<const EffectInputs> InputsOf(const Log& log, const std::string& name, Dof dof) {
  auto inputs = std::make_shared<EffectInputs>();
  inputs->log = name;
  inputs->dof = dof;
  inputs->command = CommandOf(log, dof);
  for (const Dof other : kAllDofs) {
    if (log.velocity) {
      if (const auto* column = log.velocity->Find(VelocityColumn(other))) {
        inputs->velocity[Index(other)] = PartnerVelocity(log.velocity->time, *column);
      }
    }
    if (log.command) {
      if (const auto* column = log.command->Find(ForceColumn(other))) {
        inputs->force[Index(other)] = {log.command->time, *column};
      }
    }
  }
  return inputs;
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

void Append(const Channel& channel, double from, double to, Channel* out) {
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
  std::optional<Channel> velocity, displacement;
};

// The stretches of one log, cut at silences and at the ends of held-out intervals.
void AppendRecords(const LogChannels& channels,
                   Dof dof,
                   bool use_velocity,
                   bool use_displacement,
                   Records* records) {
  const Log& log = *channels.log;
  const auto inputs = InputsOf(log, channels.name, dof);
  const Channel& leading = use_velocity ? *channels.velocity : *channels.displacement;
  const std::vector<double>& time = leading.time;
  const size_t first =
      std::lower_bound(time.begin(), time.end(), inputs->command.time.front()) - time.begin();
  if (first > 0) {
    records->remarks.push_back(fmt::format(
        "{}: left out: {} motion samples before the first command.", channels.name, first));
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
      Channel part;
      if (use_velocity) {
        Append(*channels.velocity, time[begin], time[end - 1], &part);
        record.stamps.velocity = std::move(part.time);
        record.velocity = std::move(part.value);
      }
      if (use_displacement) {
        Append(*channels.displacement, time[begin], time[end - 1], &part);
        record.stamps.displacement = std::move(part.time);
        record.displacement = std::move(part.value);
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
        own.velocity = Channel{log.velocity->time, *column};
      }
    }
    own.displacement = DisplacementOf(log, own.name, dof, &records.remarks);
    if (!own.velocity && !own.displacement) MotionStream(log, dof, Source::kPoseEstimator);
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

Bins::Bins(std::span<const Record> records) {
  for (size_t index = 0; index < records.size(); ++index) {
    const Record& record = records[index];
    first_rows_.push_back(size());
    const double width = std::clamp(record.duration() / 3000.0, 0.2, 0.5);
    struct Row {
      double time;
      Bin bin;
    };
    std::vector<Row> rows;
    const auto add = [&](const std::vector<double>& time, NoiseChannel channel) {
      for (size_t begin = 0; begin < time.size();) {
        size_t end = begin + 1;
        double sum = time[begin];
        while (end < time.size() && time[end] - time[begin] < width - 1e-6) sum += time[end++];
        rows.push_back({sum / static_cast<double>(end - begin), {channel, begin, end}});
        begin = end;
      }
    };
    add(record.stamps.velocity, NoiseChannel::kVelocity);
    add(record.stamps.displacement, NoiseChannel::kDisplacement);
    std::stable_sort(
        rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.time < b.time; });
    std::array<std::vector<size_t>, 2> counts;
    for (const Row& row : rows) {
      counts[static_cast<size_t>(row.bin.channel)].push_back(row.bin.end - row.bin.begin);
    }
    std::array<double, 2> usual = {1.0, 1.0};
    for (size_t channel = 0; channel < 2; ++channel) {
      auto& of_channel = counts[channel];
      if (of_channel.empty()) continue;
      const auto middle = of_channel.begin() + static_cast<std::ptrdiff_t>(of_channel.size() / 2);
      std::nth_element(of_channel.begin(), middle, of_channel.end());
      usual[channel] = static_cast<double>(*middle);
    }
    for (const Row& row : rows) {
      const auto count = static_cast<double>(row.bin.end - row.bin.begin);
      bins_.push_back(row.bin);
      samples_.push_back({row.time,
                          row.bin.channel,
                          usual[static_cast<size_t>(row.bin.channel)] / count,
                          static_cast<int>(index)});
    }
  }
  first_rows_.push_back(size());
}

void Bins::Average(std::size_t index,
                   const std::vector<double>& velocity,
                   const std::vector<double>& displacement,
                   std::span<double> to) const {
  for (int row = first_row(index); row < first_row(index + 1); ++row) {
    const Bin& bin = bins_[row];
    const auto& from = bin.channel == NoiseChannel::kVelocity ? velocity : displacement;
    double sum = 0.0;
    for (size_t i = bin.begin; i < bin.end; ++i) sum += from[i];
    to[row - first_row(index)] = sum / static_cast<double>(bin.end - bin.begin);
  }
}

void Bins::Average(std::size_t index,
                   const SensitivityMatrix& velocity,
                   const SensitivityMatrix& displacement,
                   Eigen::Ref<SensitivityMatrix> to) const {
  for (int row = first_row(index); row < first_row(index + 1); ++row) {
    const Bin& bin = bins_[row];
    const auto& from = bin.channel == NoiseChannel::kVelocity ? velocity : displacement;
    to.row(row - first_row(index)) = from.middleRows(static_cast<Eigen::Index>(bin.begin),
                                                     static_cast<Eigen::Index>(bin.end - bin.begin))
                                         .colwise()
                                         .mean();
  }
}

}  // namespace fathom
