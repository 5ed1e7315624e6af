// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/twin_motion.h"

#include "fathom/base/median.h"
#include "fathom/signal/filters/savitzky_golay.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/simulate/run_start.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastSpeed = 0.02;  // [m/s] std
constexpr double kLeastRate = 0.01;   // [rad/s] std
constexpr std::size_t kFewestSamples = 50;
constexpr double kTwinWindow = 1.0;  // [s] over which both are smoothed alike

// The step that half of the time lies in steps of or below. Where stamps come in batches, that is
// the time between batches, which the median of the steps is not.
double UsualStep(std::span<const double> time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  std::ranges::sort(steps);
  double passed = 0.0;
  for (const double step : steps) {
    passed += step;
    if (passed >= 0.5 * (time.back() - time.front())) return step;
  }
  return 0.0;
}

}  // namespace

double SpreadOf(std::span<const double> values) {
  double n = 0.0, sum = 0.0, squares = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    n += 1.0;
    sum += value;
    squares += value * value;
  }
  return n < 2.0 ? 0.0 : std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
}

double TwinMotion::SlowestStep() const {
  return std::max(MedianStep(pose_time), MedianStep(twist_time));
}

SavitzkyGolayOptions TwinFilter(const Log& log) {
  SavitzkyGolayOptions options;
  options.order = 2;
  const auto window_of = [](std::span<const double> time) {
    return std::max(kTwinWindow, 6.0 * UsualStep(time));
  };
  options.window = std::max(window_of(log.pose->time), window_of(log.velocity->time));
  return options;
}

std::vector<double> SmoothTwist(std::span<const double> time,
                                std::span<const double> twist,
                                const SavitzkyGolayOptions& filter) {
  return SavitzkyGolay(time, WayAlong(time, twist, 0), 1, filter);
}

std::vector<TwinMotion> TwinMotionsOf(const Log& log) {
  if (!log.pose || !log.velocity) return {};
  const Stream& pose = *log.pose;
  const Stream& velocity = *log.velocity;
  if (pose.time.size() < kFewestSamples || velocity.time.size() < kFewestSamples) return {};
  const SavitzkyGolayOptions options = TwinFilter(log);
  const Poses poses = PosesOf(pose);
  const BodyVelocity from_pose = VelocityOf(poses, options);
  std::vector<TwinMotion> motions;
  for (const Dof dof : kAllDofs) {
    const std::string column(VelocityColumn(dof));
    const std::vector<double>* twist = velocity.Find(column);
    if (twist == nullptr || !TellsMotion(pose, dof)) continue;
    std::vector<double> along(from_pose.velocity.size(), kNan), in_world;
    if (!IsAngular(dof)) in_world = along;
    for (std::size_t i = 0; i < along.size(); ++i) {
      if (!from_pose.is_centred[i]) continue;
      along[i] = from_pose.velocity[i][Index(dof)];
      if (in_world.empty()) continue;
      in_world[i] = (poses.world_from_body[i] * from_pose.velocity[i].head<3>())[Index(dof)];
    }
    std::vector<double> smooth = SmoothTwist(velocity.time, *twist, options);
    const double least = IsAngular(dof) ? kLeastRate : kLeastSpeed;
    if (SpreadOf(along) < least || SpreadOf(smooth) < least) continue;
    motions.push_back({dof,
                       column,
                       pose.time,
                       std::move(along),
                       std::move(in_world),
                       velocity.time,
                       std::move(smooth),
                       options.window});
  }
  return motions;
}

std::vector<double> AtPoses(const TwinMotion& motion, double delay) {
  std::vector<double> twist;
  for (const double t : motion.pose_time) {
    twist.push_back(ValueAt(motion.twist_time, motion.twist, t + delay));
  }
  return twist;
}

double ValueAt(std::span<const double> time,
               std::span<const double> values,
               double t,
               double longest_step) {
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  if (after == time.end()) return kNan;
  const auto i = static_cast<std::size_t>(after - time.begin());
  if (*after == t) return values[i];
  if (i == 0 || time[i] - time[i - 1] > longest_step) return kNan;
  const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

Misfit MisfitTo(const std::vector<double>& at_poses, const TwinMotion& motion) {
  const std::vector<double> twist = AtPoses(motion);
  Misfit misfit;
  for (std::size_t i = 0; i < twist.size(); ++i) {
    if (!std::isfinite(twist[i]) || !std::isfinite(at_poses[i])) continue;
    misfit.twist += twist[i] * twist[i];
    misfit.difference += (twist[i] - at_poses[i]) * (twist[i] - at_poses[i]);
  }
  return misfit;
}

Likeness LikenessAt(double delay, const TwinMotion& motion) {
  double n = 0.0, sum_a = 0.0, sum_b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < motion.pose_time.size(); ++i) {
    const double a = motion.from_pose[i];
    const double b = ValueAt(motion.twist_time, motion.twist, motion.pose_time[i] + delay);
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    n += 1.0;
    sum_a += a;
    sum_b += b;
    aa += a * a;
    bb += b * b;
    ab += a * b;
  }
  if (n < static_cast<double>(kFewestSamples)) return {};
  const double var_a = aa - sum_a * sum_a / n;
  const double var_b = bb - sum_b * sum_b / n;
  const double cov = ab - sum_a * sum_b / n;
  if (!(var_a > 0.0) || !(var_b > 0.0)) return {};
  // The gain of two noisy curves: the ratio of their spreads, with the sign of what they share.
  return {cov / std::sqrt(var_a * var_b),
          std::copysign(std::sqrt(var_b / var_a), cov),
          std::sqrt(bb / aa)};
}

}  // namespace fathom
