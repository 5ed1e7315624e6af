// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/pose_twist_check.h"

#include "fathom/findings/mount_check.h"
#include "fathom/findings/twin_motion.h"
#include "fathom/findings/twist_scale.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kLargestDelay = 3.0;     // [s] looked at
constexpr double kLargestOfSign = 0.3;    // [s]: a sign is judged without a delay above this
constexpr double kTwistDelayStep = 0.05;  // [s]
constexpr double kLeastDelay = 0.15;      // [s] told
constexpr double kSurelyOne = 0.8;        // correlation from which on two motions are one
constexpr double kHardlyOne = 0.4;        // below it, they are not
constexpr double kLargestScale = 1.25;    // told beyond it

// Velocities are along the world if what they miss of the pose's along the vehicle is more than
// this part of their squares, and what they miss along the world less than that part of it.
constexpr double kLeastMisfit = 0.002;
constexpr double kInWorld = 0.25;

// A curve that only grows is like itself at any delay: a delay counts if it takes away a fifth of
// what the two do not share, and lies within what is looked at.
bool IsDelayed(const Likeness& as_is, const Likeness& delayed, double delay) {
  return delayed.correlation >= kSurelyOne &&
         std::abs(delay) < kLargestDelay - kTwistDelayStep / 2.0 &&
         1.0 - delayed.correlation < 0.8 * (1.0 - as_is.correlation);
}

Finding FindingOf(const TwinMotion& motion,
                  Severity severity,
                  const char* code,
                  const std::string& text) {
  return {
      severity,
      code,
      fmt::format("velocity.csv: {} and the {} velocity that pose.csv gives {}",
                  motion.column,
                  Name(motion.dof),
                  text),
      FindingPlace{
          "velocity.csv", motion.column, {motion.twist_time.front(), motion.twist_time.back()}}};
}

std::optional<Finding> CheckFrame(const std::vector<TwinMotion>& motions) {
  double squares = 0.0, of_vehicle = 0.0, of_world = 0.0;
  std::vector<std::string> columns;
  const TwinMotion* worst = nullptr;
  double most = 0.0;
  for (const TwinMotion& motion : motions) {
    if (motion.in_world.empty()) continue;
    const Misfit vehicle = MisfitTo(motion.from_pose, motion);
    squares += vehicle.twist;
    of_vehicle += vehicle.difference;
    of_world += MisfitTo(motion.in_world, motion).difference;
    columns.push_back(motion.column);
    if (!(vehicle.difference > most)) continue;
    most = vehicle.difference;
    worst = &motion;
  }
  if (!(of_vehicle > kLeastMisfit * squares) || !(of_world < kInWorld * of_vehicle)) {
    return std::nullopt;
  }
  const auto percent = [&](double misfit) { return 100.0 * std::sqrt(misfit / squares); };
  Finding finding = FindingOf(*worst, Severity::kWarning, "pose_twist_frame", "");
  finding.sentence = fmt::format(
      "velocity.csv: {} {} along the axes of the world, not of the vehicle: {:.0f} % off the "
      "velocity that pose.csv gives along the vehicle, {:.1f} % off along the world.",
      fmt::join(columns, ", "),
      columns.size() == 1 ? "is" : "are",
      percent(of_vehicle),
      percent(of_world));
  return finding;
}

// What the two are at that one of the delays at which they are most alike.
struct AxisLikeness {
  Likeness near;            // without much of a delay, of either sign
  double near_delay = 0.0;  // [s]
  Likeness best;            // of the same sign
  double best_delay = 0.0;  // [s]
};

AxisLikeness LikenessOf(const TwinMotion& motion) {
  AxisLikeness axis;
  for (int i = 0; i <= static_cast<int>(kLargestDelay / kTwistDelayStep); ++i) {
    for (const double delay : {kTwistDelayStep * i, -kTwistDelayStep * i}) {
      const Likeness here = LikenessAt(delay, motion);
      if (std::abs(delay) <= kLargestOfSign &&
          std::abs(here.correlation) > std::abs(axis.near.correlation)) {
        axis.near = here;
        axis.near_delay = delay;
      }
      if (here.correlation > axis.best.correlation) {
        axis.best = here;
        axis.best_delay = delay;
      }
    }
  }
  return axis;
}

// How many times the one is the other; where the rows are too few for an interval, as regression
// has it.
TwistScale ScaleOr(double gain, const TwinMotion& motion, double delay) {
  const TwistScale scale = TwistScaleOf(motion, delay);
  return std::isfinite(scale.factor) ? scale : TwistScale{gain, scale.half_width};
}

std::optional<Finding> CheckAxis(const TwinMotion& motion, const AxisLikeness& axis) {
  const auto& [near, near_delay, best, best_delay] = axis;
  if (near.correlation <= -kSurelyOne) {
    return FindingOf(
        motion,
        Severity::kWarning,
        "pose_twist_sign",
        fmt::format("have opposite signs: a correlation of {:.2f}, a factor of {}. One of them has "
                    "a wrong sign or axis.",
                    near.correlation,
                    FormatTwistScale(ScaleOr(near.gain, motion, near_delay))));
  }
  const bool is_larger = std::min(best.gain, best.size) > kLargestScale;
  const bool is_smaller = std::max(best.gain, best.size) < 1.0 / kLargestScale;
  if (best.correlation >= kSurelyOne && (is_larger || is_smaller)) {
    return FindingOf(motion,
                     Severity::kWarning,
                     "pose_twist_scale",
                     fmt::format("differ by a factor of {}: one of them has a wrong unit or "
                                 "scale.",
                                 FormatTwistScale(ScaleOr(best.gain, motion, best_delay))));
  }
  const double step = motion.SlowestStep();
  if (IsDelayed(LikenessAt(0.0, motion), best, best_delay) &&
      std::abs(best_delay) > std::max(kLeastDelay, 2.0 * step - 1e-6)) {
    return FindingOf(motion,
                     Severity::kNote,
                     "pose_twist_delay",
                     fmt::format("are the same motion, but {} is {:.2f} s later.",
                                 best_delay > 0.0 ? "velocity.csv" : "pose.csv",
                                 std::abs(best_delay)));
  }
  if (std::max(best.correlation, std::abs(near.correlation)) < kHardlyOne) {
    return FindingOf(
        motion,
        Severity::kWarning,
        "pose_twist_apart",
        fmt::format("both move, but not together (correlation {:.2f} at most). They are "
                    "along different axes, or one is no measurement.",
                    best.correlation));
  }
  return std::nullopt;
}

// The linear columns that a sensor's place may explain: all but those of a wrong sign or scale. One
// whose delay is not known comes as late as another.
std::vector<LateColumn> ColumnsOfSensor(const Log& log,
                                        const std::vector<LateColumn>& matched,
                                        const std::vector<Dof>& wrong) {
  std::vector<LateColumn> columns;
  for (const Dof dof : {Dof::kSurge, Dof::kSway, Dof::kHeave}) {
    if (log.velocity->Find(VelocityColumn(dof)) == nullptr) continue;
    if (std::ranges::find(wrong, dof) != wrong.end()) continue;
    const auto own = std::ranges::find(matched, dof, &LateColumn::dof);
    const double other = matched.empty() ? 0.0 : matched.front().delay;
    columns.push_back({dof, own == matched.end() ? other : own->delay});
  }
  return columns;
}

}  // namespace

std::vector<Finding> CheckPoseAgainstTwist(const Log& log) {
  std::vector<Finding> findings;
  const std::vector<TwinMotion> motions = TwinMotionsOf(log);
  const auto frame = CheckFrame(motions);
  std::vector<LateColumn> matched;
  std::vector<Dof> wrong;
  if (frame) findings.push_back(*frame);
  for (const TwinMotion& motion : motions) {
    if (frame && !IsAngular(motion.dof)) continue;
    const AxisLikeness axis = LikenessOf(motion);
    if (axis.best.correlation >= kSurelyOne) matched.push_back({motion.dof, axis.best_delay});
    auto finding = CheckAxis(motion, axis);
    if (!finding) continue;
    if (finding->code == "pose_twist_sign" || finding->code == "pose_twist_scale") {
      wrong.push_back(motion.dof);
    }
    findings.push_back(*std::move(finding));
  }
  if (frame || motions.empty()) return findings;
  const std::vector<LateColumn> columns = ColumnsOfSensor(log, matched, wrong);
  const std::optional<SensorMount> mount = SensorMountOf(log, columns);
  if (!mount) return findings;
  std::vector<Finding> of_mount = CheckSensorMount(*mount, log, columns);
  // Columns that are another motion because of their sensor's place are not called so twice.
  if (!of_mount.empty()) {
    std::erase_if(findings, [&](const Finding& finding) {
      return finding.code == "pose_twist_apart" &&
             std::ranges::any_of(columns, [&](const LateColumn& column) {
               return VelocityColumn(column.dof) == finding.where->axis &&
                      mount->Explains(column.dof);
             });
    });
  }
  std::ranges::move(of_mount, std::back_inserter(findings));
  return findings;
}

}  // namespace fathom
