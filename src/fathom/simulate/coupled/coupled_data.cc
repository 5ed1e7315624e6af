// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_data.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/signal/filter_window.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/signal/split_at_gaps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kFewestOfCoupled = 20;  // samples of a segment
constexpr double kLongestCoupledGap = 2.0;    // [s]; a longer silence cuts the motion
constexpr int kFilterOrder = 3;               // of the polynomial that makes velocities of poses
constexpr double kStartReach = 0.5;           // [s] to either side
constexpr std::size_t kFewestOfStart = 5;     // samples that a start is taken from

// The forces of a log, or its thrusts where the vehicle file says what they do.
CoupledCommand CoupledCommandOf(const Log& log, std::span<const Thruster> thrusters) {
  CoupledCommand command;
  const bool by_thruster =
      log.thrusters && !thrusters.empty() && log.thrusters->columns.size() == thrusters.size();
  if (by_thruster) {
    const auto allocation = AllocationMatrix({thrusters.begin(), thrusters.end()});
    command.time = log.thrusters->time;
    for (std::size_t k = 0; k < thrusters.size(); ++k) {
      const auto* thrust = log.thrusters->Find(fmt::format("thruster_{}", k + 1));
      if (thrust == nullptr) continue;
      command.thrusters.push_back(
          {thrusters[k].name, allocation.col(static_cast<Eigen::Index>(k)), *thrust});
    }
    return command;
  }
  if (!log.command) return command;
  command.time = log.command->time;
  command.force.assign(command.time.size(), Vector6::Zero());
  for (const Dof dof : kAllDofs) {
    const auto* force = log.command->Find(ForceColumn(dof));
    if (force == nullptr) continue;
    for (std::size_t i = 0; i < force->size(); ++i) command.force[i][Index(dof)] = (*force)[i];
  }
  return command;
}

// Refuses angles that are none in radians, and tells of those beyond the fin's largest.
void CheckAngles(const Log& log,
                 const Fin& fin,
                 const std::vector<double>& angles,
                 std::vector<std::string>* remarks) {
  double largest = 0.0;
  for (const double angle : angles) largest = std::max(largest, std::abs(angle));
  if (largest > std::numbers::pi / 2.0) {
    throw InputError(fmt::format(
        "{}: command.csv: fin_{} goes to {:.3g}, expected an angle in radians below a right angle. "
        "Is it in degrees?",
        log.path.string(),
        fin.name,
        largest));
  }
  if (fin.largest_angle && largest > *fin.largest_angle) {
    remarks->push_back(fmt::format(
        "fin_{} goes to {:.3g} rad, beyond the {:.3g} rad that the vehicle file calls its largest.",
        fin.name,
        largest,
        *fin.largest_angle));
  }
}

// Adds the log's fins, whose angles stand at the command's stamps.
void AddFins(const Log& log,
             std::span<const Fin> fins,
             CoupledCommand* command,
             std::vector<std::string>* remarks) {
  if (!log.fins) return;
  if (command->time.empty()) command->time = log.fins->time;
  for (std::size_t k = 0; k < log.fins->columns.size(); ++k) {
    const std::string name = log.fins->columns[k].substr(std::string_view("fin_").size());
    const auto fin =
        std::find_if(fins.begin(), fins.end(), [&](const Fin& f) { return f.name == name; });
    if (fin == fins.end()) {
      throw InputError(fmt::format(
          "{}: command.csv holds {}, expected the vehicle file to name a fin '{}': `fins: [{{name: "
          "{}, position: [x, y, z], axis: [0, 0, 1]}}]`.",
          log.path.string(),
          log.fins->columns[k],
          name,
          name));
    }
    CheckAngles(log, *fin, log.fins->values[k], remarks);
    command->fins.push_back(
        {name, ArmsOf(*fin), log.fins->values[k], fin->behind, FinForceOf(*fin)});
  }
}

// Adds the log's shafts, whose revolutions stand at the command's stamps.
void AddShafts(const Log& log, std::span<const Shaft> shafts, CoupledCommand* command) {
  if (!log.shafts) return;
  if (command->time.empty()) command->time = log.shafts->time;
  for (std::size_t k = 0; k < log.shafts->columns.size(); ++k) {
    const std::string name = log.shafts->columns[k].substr(std::string_view("shaft_").size());
    const auto shaft = std::ranges::find(shafts, name, &Shaft::name);
    if (shaft == shafts.end()) {
      throw InputError(fmt::format(
          "{}: command.csv holds {}, expected the vehicle file to name a shaft '{}': `shafts: "
          "[{{name: {}, position: [x, y, z], diameter: D}}]`.",
          log.path.string(),
          log.shafts->columns[k],
          name,
          name));
    }
    command->shafts.push_back(CommandedShaftOf(*shaft));
    command->shafts.back().turns = log.shafts->values[k];
  }
}

// Whether anything acts along a DOF.
bool IsCommanded(const CoupledCommand& command, Dof dof) {
  const auto row = Index(dof);
  const bool by_force = std::any_of(
      command.force.begin(), command.force.end(), [&](const auto& f) { return f[row] != 0.0; });
  const bool by_fin = std::any_of(command.fins.begin(), command.fins.end(), [&](const auto& fin) {
    return fin.arms.across[row] != 0.0;
  });
  const bool by_shaft = std::ranges::any_of(command.shafts, [&](const CommandedShaft& shaft) {
    return shaft.push[row] != 0.0 &&
           std::ranges::any_of(shaft.turns, [](double turns) { return turns != 0.0; });
  });
  return by_force || by_fin || by_shaft ||
         std::any_of(command.thrusters.begin(), command.thrusters.end(), [&](const auto& thruster) {
           return thruster.push[row] != 0.0 &&
                  std::any_of(thruster.thrust.begin(), thruster.thrust.end(), [](double thrust) {
                    return thrust != 0.0;
                  });
         });
}

// Velocities at stamps of their own; rows of NaN where they are not known.
struct VelocityRows {
  std::vector<double> time;
  std::vector<Vector6> velocity;
};

VelocityRows FromPoses(const Stream& stream) {
  VelocityRows rows;
  const Poses poses = PosesOf(stream);
  if (poses.size() < kFewestOfCoupled) return rows;
  const auto told = std::find_if(
      kAllDofs.begin(), kAllDofs.end(), [&](Dof dof) { return TellsMotion(stream, dof); });
  if (told == kAllDofs.end()) return rows;
  const double window = FilterWindowFor(
      poses.time, DisplacementAlong(*told, poses), SplitAtGaps(poses.time), kFilterOrder);
  const BodyVelocity body = VelocityOf(poses, {.window = window, .order = kFilterOrder});
  rows.time = poses.time;
  rows.velocity = body.velocity;
  for (const Dof dof : kAllDofs) {
    if (TellsMotion(stream, dof)) continue;
    for (Vector6& velocity : rows.velocity) velocity[Index(dof)] = kNotKnown;
  }
  return rows;
}

double BetweenSamples(const SampledSignal& signal, double t) {
  const auto next = std::lower_bound(signal.time.begin(), signal.time.end(), t);
  if (next == signal.time.end() || (next == signal.time.begin() && *next > t)) return kNotKnown;
  const auto at = static_cast<std::size_t>(next - signal.time.begin());
  if (signal.time[at] == t || at == 0) return signal.value[at];
  const double share = (t - signal.time[at - 1]) / (signal.time[at] - signal.time[at - 1]);
  return (1.0 - share) * signal.value[at - 1] + share * signal.value[at];
}

// What a column of rows knows.
SampledSignal ColumnOf(const VelocityRows& rows, Dof dof) {
  SampledSignal signal;
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    const double value = rows.velocity[i][Index(dof)];
    if (!std::isfinite(value)) continue;
    signal.time.push_back(rows.time[i]);
    signal.value.push_back(value);
  }
  return signal;
}

Vector6 AllUnknown() { return Vector6::Constant(kNotKnown); }

// velocity.csv, with what it lacks from the poses; or the poses' alone.
VelocityRows AllVelocities(const Log& log, std::array<bool, 6>* has_velocity) {
  VelocityRows from_poses;
  if (log.pose) from_poses = FromPoses(*log.pose);
  if (!log.velocity) return from_poses;
  VelocityRows rows = {log.velocity->time, {}};
  rows.velocity.assign(rows.time.size(), AllUnknown());
  for (const Dof dof : kAllDofs) {
    const auto row = Index(dof);
    if (const auto* column = log.velocity->Find(VelocityColumn(dof))) {
      (*has_velocity)[static_cast<std::size_t>(row)] = true;
      for (std::size_t i = 0; i < rows.time.size(); ++i) rows.velocity[i][row] = (*column)[i];
      continue;
    }
    const SampledSignal known = ColumnOf(from_poses, dof);
    if (known.time.empty()) continue;
    for (std::size_t i = 0; i < rows.time.size(); ++i) {
      rows.velocity[i][row] = BetweenSamples(known, rows.time[i]);
    }
  }
  return rows;
}

void AddPoses(const Log& log, double from, double to, CoupledSegment* segment) {
  if (!log.pose) return;
  const Stream& stream = *log.pose;
  const Poses poses = PosesOf(stream);
  const bool has_attitude = stream.Find("qw") != nullptr;
  const bool has_x = stream.Find("x") != nullptr, has_z = stream.Find("z") != nullptr;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (poses.time[i] < from || poses.time[i] > to) continue;
    segment->pose_time.push_back(poses.time[i]);
    if (has_attitude) segment->attitude.push_back(poses.world_from_body[i]);
    Eigen::Vector3d position = poses.position[i];
    if (!has_x) position.head<2>().setConstant(kNotKnown);
    if (!has_z) position[2] = kNotKnown;
    segment->position.push_back(position);
  }
}

void RequireMotion(const Log& log, const VelocityRows& rows, const std::vector<Dof>& dofs) {
  for (const Dof dof : dofs) {
    const bool is_known = std::any_of(rows.velocity.begin(),
                                      rows.velocity.end(),
                                      [&](const auto& v) { return std::isfinite(v[Index(dof)]); });
    if (is_known) continue;
    throw InputError(
        fmt::format("{}: measures no {}, which is to be modelled, expected a column '{}' of "
                    "velocity.csv or poses that tell it.",
                    log.path.string(),
                    Name(dof),
                    VelocityColumn(dof)));
  }
}

// The stamps of a command, of which nothing was measured.
CoupledSegment CommandAlone(const CoupledCommand& command) {
  CoupledSegment segment;
  segment.time = command.time;
  segment.velocity.assign(command.time.size(), AllUnknown());
  return segment;
}

// The weighted line through the samples about one, evaluated there.
double LineThroughSamples(const CoupledSegment& segment,
                          std::size_t first,
                          std::size_t last,
                          Eigen::Index row,
                          double t) {
  double n = 0.0, sum_t = 0.0, sum_v = 0.0, sum_tt = 0.0, sum_tv = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const double v = segment.velocity[i][row];
    if (!std::isfinite(v)) continue;
    const double dt = segment.time[i] - t;
    n += 1.0;
    sum_t += dt;
    sum_v += v;
    sum_tt += dt * dt;
    sum_tv += dt * v;
  }
  if (n == 0.0) return 0.0;
  const double det = n * sum_tt - sum_t * sum_t;
  if (n < 3.0 || !(det > 1e-12 * n * sum_tt)) return sum_v / n;
  return (sum_tt * sum_v - sum_t * sum_tv) / det;
}

}  // namespace

CoupledData CoupledDataOf(const Log& log,
                          const std::vector<Dof>& dofs,
                          std::span<const Thruster> thrusters,
                          std::span<const Fin> fins,
                          std::span<const Shaft> shafts) {
  CoupledData data;
  data.log = data.inputs.log = log.name;
  data.dofs = dofs;
  data.force_unit = log.command_unit.empty() ? "N" : log.command_unit;
  data.inputs.command = CoupledCommandOf(log, thrusters);
  AddFins(log, fins, &data.inputs.command, &data.remarks);
  AddShafts(log, shafts, &data.inputs.command);
  const VelocityRows rows = AllVelocities(log, &data.has_velocity);
  const bool has_motion = log.velocity || log.pose;
  if (has_motion) RequireMotion(log, rows, dofs);
  if (std::none_of(dofs.begin(), dofs.end(), [&](Dof dof) {
        return IsCommanded(data.inputs.command, dof);
      })) {
    throw InputError(fmt::format(
        "{}: commands none of these DOFs, expected a force, a shaft that turns or a fin "
        "(fin_<name> in command.csv: docs/fins.md).",
        log.path.string()));
  }
  for (const Dof dof : kAllDofs) {
    if (std::find(dofs.begin(), dofs.end(), dof) != dofs.end()) continue;
    data.inputs.measured[static_cast<std::size_t>(Index(dof))] = ColumnOf(rows, dof);
  }
  if (log.pose) {
    data.has_attitude = log.pose->Find("qw") != nullptr;
    const bool has_x = log.pose->Find("x") != nullptr;
    data.has_position = {has_x, has_x, log.pose->Find("z") != nullptr};
  }
  if (!has_motion) {
    data.segments.push_back(CommandAlone(data.inputs.command));
    data.remarks.emplace_back(
        "No motion was measured: the run begins at rest, level, at the first command.");
    return data;
  }
  const double first_command = data.inputs.command.time.front();
  const auto first = static_cast<std::size_t>(
      std::lower_bound(rows.time.begin(), rows.time.end(), first_command) - rows.time.begin());
  if (first > 0) {
    data.remarks.push_back(
        fmt::format("Left out: {} before the first command.", Plural(first, "motion sample")));
  }
  const LongRanges kept = WithoutShort(
      SplitAtGaps(rows.time, log.held_out, first, kLongestCoupledGap), kFewestOfCoupled);
  if (kept.num_short > 0) {
    data.remarks.push_back(fmt::format("Left out: {} of fewer than {} samples ({} samples).",
                                       Plural(kept.num_short, "segment"),
                                       kFewestOfCoupled,
                                       kept.num_samples_in_short));
  }
  for (const SampleRange& range : kept.ranges) {
    CoupledSegment& segment = data.segments.emplace_back();
    segment.is_held_out = range.is_held_out;
    const auto cut = [&](const auto& all) {
      return std::vector(all.begin() + static_cast<std::ptrdiff_t>(range.begin),
                         all.begin() + static_cast<std::ptrdiff_t>(range.end));
    };
    segment.time = cut(rows.time);
    segment.velocity = cut(rows.velocity);
    AddPoses(log, segment.time.front(), segment.time.back(), &segment);
  }
  if (data.segments.empty()) {
    throw InputError(
        fmt::format("{}: no segment of the motion has {} samples without a gap of over {:g} s.",
                    log.path.string(),
                    kFewestOfCoupled,
                    kLongestCoupledGap));
  }
  return data;
}

CoupledState MeasuredState(const CoupledSegment& segment, std::size_t sample) {
  CoupledState state;
  const double t = segment.time[sample];
  std::size_t first = sample, last = sample;
  const auto grow = [&](double reach, std::size_t fewest) {
    while (first > 0 && (t - segment.time[first - 1] <= reach)) --first;
    while (last + 1 < segment.time.size() && segment.time[last + 1] - t <= reach) ++last;
    while (last - first + 1 < fewest && (first > 0 || last + 1 < segment.time.size())) {
      if (first > 0) --first;
      if (last + 1 < segment.time.size()) ++last;
    }
  };
  grow(kStartReach, kFewestOfStart);
  for (Eigen::Index row = 0; row < 6; ++row) {
    state.nu[row] = LineThroughSamples(segment, first, last, row, t);
  }
  const auto next = std::lower_bound(segment.pose_time.begin(), segment.pose_time.end(), t);
  if (segment.pose_time.empty()) return state;
  const auto after = std::min(static_cast<std::size_t>(next - segment.pose_time.begin()),
                              segment.pose_time.size() - 1);
  const auto before = after > 0 ? after - 1 : after;
  const double step = segment.pose_time[after] - segment.pose_time[before];
  const double share =
      step > 0.0 ? std::clamp((t - segment.pose_time[before]) / step, 0.0, 1.0) : 0.0;
  if (!segment.attitude.empty()) {
    state.attitude =
        segment.attitude[before].slerp(share, segment.attitude[after]).normalized().coeffs();
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double position =
        (1.0 - share) * segment.position[before][axis] + share * segment.position[after][axis];
    if (std::isfinite(position)) state.position[axis] = position;
  }
  return state;
}

std::vector<SampleWindow> WindowsOf(const CoupledSegment& segment, double length) {
  const double duration = segment.time.back() - segment.time.front();
  // No more than there are pairs of samples.
  const double ratio = std::min(duration / length, 0.5 * static_cast<double>(segment.time.size()));
  const auto num = ratio < 1.5 ? std::size_t{1} : static_cast<std::size_t>(std::lround(ratio));
  std::vector<SampleWindow> windows;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < num; ++k) {
    const double until =
        segment.time.front() + duration * static_cast<double>(k + 1) / static_cast<double>(num);
    const auto end = k + 1 == num
                         ? segment.time.size()
                         : static_cast<std::size_t>(
                               std::lower_bound(segment.time.begin(), segment.time.end(), until) -
                               segment.time.begin());
    if (end < begin + 2) continue;  // they go to the next one
    windows.push_back({begin, end});
    begin = end;
  }
  if (windows.empty()) windows.push_back({0, 0});
  windows.back().end = segment.time.size();
  return windows;
}

}  // namespace fathom
