// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/pose_twist_check.h"

#include "fathom/check/twin_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLargestDelay = 3.0;   // [s] looked at
constexpr double kLargestOfSign = 0.3;  // [s]: a sign is judged without a delay above this
constexpr double kDelayStep = 0.05;     // [s]
constexpr double kLeastDelay = 0.15;    // [s] told
constexpr double kSurelyOne = 0.8;      // correlation from which on two motions are one
constexpr double kHardlyOne = 0.4;      // below it, they are not
constexpr double kLargestScale = 1.25;  // told beyond it

// A curve that only grows is like itself at any delay: a delay counts if it takes away a fifth of
// what the two do not share, and lies within what is looked at.
bool IsDelayed(const Likeness& as_is, const Likeness& delayed, double delay) {
  return delayed.correlation >= kSurelyOne && std::abs(delay) < kLargestDelay - kDelayStep / 2.0 &&
         1.0 - delayed.correlation < 0.8 * (1.0 - as_is.correlation);
}

Finding FindingOf(const TwinMotion& motion,
                  Severity severity,
                  const char* code,
                  const std::string& text) {
  return {severity,
          code,
          fmt::format("velocity.csv: {} and the {} velocity that pose.csv gives {}",
                      motion.column,
                      Name(motion.dof),
                      text)};
}

std::optional<Finding> CheckAxis(const TwinMotion& motion) {
  const auto likeness = [&](double delay) { return LikenessAt(delay, motion); };
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
        motion,
        Severity::kWarning,
        "pose_twist_sign",
        fmt::format("have opposite signs (correlation {:.2f}). One of them has a wrong "
                    "sign or axis.",
                    near.correlation));
  }
  const bool is_larger = std::min(best.gain, best.size) > kLargestScale;
  const bool is_smaller = std::max(best.gain, best.size) < 1.0 / kLargestScale;
  if (best.correlation >= kSurelyOne && (is_larger || is_smaller)) {
    return FindingOf(motion,
                     Severity::kWarning,
                     "pose_twist_scale",
                     fmt::format("differ by a factor of {:.3g}: one of them has a wrong unit or "
                                 "scale.",
                                 best.gain));
  }
  const double step = motion.SlowestStep();
  if (IsDelayed(likeness(0.0), best, best_delay) &&
      std::abs(best_delay) > std::max(kLeastDelay, 2.0 * step)) {
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

}  // namespace

std::vector<Finding> CheckPoseAgainstTwist(const Log& log) {
  std::vector<Finding> findings;
  for (const TwinMotion& motion : TwinMotionsOf(log)) {
    if (auto finding = CheckAxis(motion)) findings.push_back(*std::move(finding));
  }
  return findings;
}

}  // namespace fathom
