// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/pose_twist_check.h"

#include "fathom/base/median.h"
#include "fathom/signal/filters/savitzky_golay.h"
#include "fathom/signal/pose_velocity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargestDelay = 3.0;   // [s] looked at
constexpr double kLargestOfSign = 0.3;  // [s]: a sign is judged without a delay above this
constexpr double kDelayStep = 0.05;     // [s]
constexpr double kLeastDelay = 0.15;    // [s] told
constexpr double kSurelyOne = 0.8;      // correlation from which on two motions are one
constexpr double kHardlyOne = 0.4;      // below it, they are not
constexpr double kLargestScale = 1.25;  // told beyond it
constexpr double kLeastSpeed = 0.02;    // [m/s] std
constexpr double kLeastRate = 0.01;     // [rad/s] std
constexpr std::size_t kFewestSamples = 50;
constexpr double kWindow = 1.0;  // [s] over which both are smoothed alike

// What `later`, delayed by nothing, and `earlier` share.
struct Likeness {
  double correlation = 0.0;
  double gain = kNan;  // of the twist over the pose's velocity, both about their means
  double size = kNan;  // of their root mean squares
};

// The value of a curve at a time, on straight lines; NaN beyond its ends.
double At(std::span<const double> time, std::span<const double> values, double t) {
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  if (after == time.end()) return kNan;
  const auto i = static_cast<std::size_t>(after - time.begin());
  if (*after == t) return values[i];
  if (i == 0) return kNan;
  const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

// Of the pose's velocity at its stamps and the twist `delay` later.
Likeness LikenessAt(double delay,
                    std::span<const double> pose_time,
                    std::span<const double> from_pose,
                    std::span<const double> twist_time,
                    std::span<const double> twist) {
  double n = 0.0, sum_a = 0.0, sum_b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < pose_time.size(); ++i) {
    const double a = from_pose[i];
    const double b = At(twist_time, twist, pose_time[i] + delay);
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

// A curve that only grows is like itself at any delay: a delay counts if it takes away a fifth of
// what the two do not share, and lies within what is looked at.
bool IsDelayed(const Likeness& as_is, const Likeness& delayed, double delay) {
  return delayed.correlation >= kSurelyOne && std::abs(delay) < kLargestDelay - kDelayStep / 2.0 &&
         1.0 - delayed.correlation < 0.8 * (1.0 - as_is.correlation);
}

double Spread(std::span<const double> values) {
  double n = 0.0, sum = 0.0, squares = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    n += 1.0;
    sum += value;
    squares += value * value;
  }
  return n < 2.0 ? 0.0 : std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
}

struct Axis {
  Dof dof;
  std::string column;
};

Finding FindingOf(const Axis& axis, Severity severity, const char* code, const std::string& text) {
  return {severity,
          code,
          fmt::format("velocity.csv: {} and the {} velocity that pose.csv gives {}",
                      axis.column,
                      Name(axis.dof),
                      text)};
}

std::optional<Finding> CheckAxis(const Axis& axis,
                                 std::span<const double> pose_time,
                                 std::span<const double> from_pose,
                                 std::span<const double> twist_time,
                                 std::span<const double> twist) {
  const double least = IsAngular(axis.dof) ? kLeastRate : kLeastSpeed;
  if (Spread(from_pose) < least || Spread(twist) < least) return std::nullopt;
  const auto likeness = [&](double delay) {
    return LikenessAt(delay, pose_time, from_pose, twist_time, twist);
  };
  Likeness near;  // the most alike without much of a delay, of either sign
  Likeness best;  // the most alike of the same sign
  double best_delay = 0.0;
  for (int i = 0; i <= static_cast<int>(kLargestDelay / kDelayStep); ++i) {
    for (const double delay : {kDelayStep * i, -kDelayStep * i}) {
      const Likeness here = likeness(delay);
      if (std::abs(delay) <= kLargestOfSign &&
          std::abs(here.correlation) > std::abs(near.correlation)) {
        near = here;
      }
      if (here.correlation > best.correlation) {
        best = here;
        best_delay = delay;
      }
    }
  }
  if (near.correlation <= -kSurelyOne) {
    return FindingOf(
        axis,
        Severity::kWarning,
        "pose_twist_sign",
        fmt::format("have opposite signs (correlation {:.2f}). One of them has a wrong "
                    "sign or axis.",
                    near.correlation));
  }
  const bool is_larger = std::min(best.gain, best.size) > kLargestScale;
  const bool is_smaller = std::max(best.gain, best.size) < 1.0 / kLargestScale;
  if (best.correlation >= kSurelyOne && (is_larger || is_smaller)) {
    return FindingOf(axis,
                     Severity::kWarning,
                     "pose_twist_scale",
                     fmt::format("differ by a factor of {:.3g}: one of them has a wrong unit or "
                                 "scale.",
                                 best.gain));
  }
  const double step = std::max(MedianStep(pose_time), MedianStep(twist_time));
  if (IsDelayed(likeness(0.0), best, best_delay) &&
      std::abs(best_delay) > std::max(kLeastDelay, 2.0 * step)) {
    return FindingOf(axis,
                     Severity::kNote,
                     "pose_twist_delay",
                     fmt::format("are the same motion, but {} is {:.2f} s later.",
                                 best_delay > 0.0 ? "velocity.csv" : "pose.csv",
                                 std::abs(best_delay)));
  }
  if (std::max(best.correlation, std::abs(near.correlation)) < kHardlyOne) {
    return FindingOf(
        axis,
        Severity::kWarning,
        "pose_twist_apart",
        fmt::format("both move, but not together (correlation {:.2f} at most). They are "
                    "along different axes, or one is no measurement.",
                    best.correlation));
  }
  return std::nullopt;
}

}  // namespace

std::vector<Finding> CheckPoseAgainstTwist(const Log& log) {
  std::vector<Finding> findings;
  if (!log.pose || !log.velocity) return findings;
  const Stream& velocity = *log.velocity;
  if (log.pose->time.size() < kFewestSamples || velocity.time.size() < kFewestSamples)
    return findings;
  SavitzkyGolayOptions options;
  options.order = 2;
  const auto window_of = [](std::span<const double> time) {
    return std::max(kWindow, 6.0 * MedianStep(time));
  };
  options.window = std::max(window_of(log.pose->time), window_of(velocity.time));
  const BodyVelocity from_pose = VelocityOf(PosesOf(*log.pose), options);
  for (const Dof dof : kAllDofs) {
    const std::string column(VelocityColumn(dof));
    const std::vector<double>* twist = velocity.Find(column);
    if (twist == nullptr) continue;
    std::vector<double> along(from_pose.velocity.size());
    for (std::size_t i = 0; i < along.size(); ++i) {
      along[i] = from_pose.is_centred[i] ? from_pose.velocity[i][Index(dof)] : kNan;
    }
    // Smoothed as the poses are, so that noise counts alike in both.
    const std::vector<double> smooth = SavitzkyGolay(velocity.time, *twist, 0, options);
    if (auto finding = CheckAxis({dof, column}, log.pose->time, along, velocity.time, smooth)) {
      findings.push_back(*std::move(finding));
    }
  }
  return findings;
}

}  // namespace fathom
