// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/failed_assumption.h"

#include "fathom/joint_refinement/search/fit_from.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kFarOff = 4.0;  // standard deviations

// From either start; the better known one first.
JointSummary FitFromAny(const JointInput& input, const JointOptions& options) {
  JointSummary summary = FitFrom(input, options, StartPoses::kTracked);
  return summary.IsUsable() ? summary : FitFrom(input, options, StartPoses::kHeldStill);
}

std::string FailedClock(const JointInput& input, JointOptions options) {
  if (options.clock_offset_std > 0.0 || options.moves_freely) return "";
  options.clock_offset_std = 1.0;
  const JointSummary fit = FitFromAny(input, options);
  if (!fit.IsUsable()) return "";
  const RefinedSegment& worst =
      *std::max_element(fit.segments.begin(), fit.segments.end(), [](const auto& a, const auto& b) {
        return std::abs(a.clock_offset) / a.clock_offset_std <
               std::abs(b.clock_offset) / b.clock_offset_std;
      });
  if (!(std::abs(worst.clock_offset) > kFarOff * worst.clock_offset_std)) return "";
  return fmt::format(
      "The corners contradict an exact camera clock. With a free one the search ends, at an offset "
      "of {:.3f} ± {:.3f} s. Correct the stamps, or estimate the offset (--clock_offset_std=1).",
      worst.clock_offset,
      worst.clock_offset_std);
}

std::string FailedSize(const JointInput& input, JointOptions options) {
  if (options.size_scale_std > 0.0) return "";
  options.size_scale_std = 0.1;
  const JointSummary fit = FitFromAny(input, options);
  if (!fit.IsUsable()) return "";
  const double off = fit.size_scale - 1.0;
  if (!(std::abs(off) > kFarOff * fit.size_scale_std)) return "";
  return fmt::format(
      "The corners contradict the size of the markers. With a free one the search ends, at {:.3f} "
      "± "
      "{:.3f} times the given size. Measure the markers, or estimate it (--size_scale_std=0.1).",
      fit.size_scale,
      fit.size_scale_std);
}

}  // namespace

std::string FailedAssumption(const JointInput& input,
                             const JointOptions& options,
                             bool reached_setup) {
  const std::string clock = FailedClock(input, options);
  return clock.empty() && reached_setup ? FailedSize(input, options) : clock;
}

}  // namespace fathom
