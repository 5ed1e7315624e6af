// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/pose_jumps.h"

#include "fathom/base/median.h"
#include "fathom/base/plural.h"
#include "fathom/findings/values/pose_yaw.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kSide = 5;      // rows on either side of a jump
constexpr double kLeastJump = 0.1;    // [m] or [rad]
constexpr double kLargeSteps = 10.0;  // times the 90 % quantile

struct Jump {
  double before = 0.0, time = 0.0;  // stamps of the rows beside it [s]
  double size = 0.0;
};

// Where the course of the values on one side is at the jump, half a row behind the last of them.
// One row that flipped counts for nothing: slope and place are medians.
double Continued(std::span<const double> values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) steps.push_back(values[i] - values[i - 1]);
  const double slope = Median(steps);
  std::vector<double> at_end;
  for (std::size_t i = 0; i < values.size(); ++i) {
    at_end.push_back(values[i] + slope * static_cast<double>(values.size() - 1 - i) + 0.5 * slope);
  }
  return Median(at_end);
}

// `turn`: a jump by so much is none; 0: of a position.
std::vector<Jump> JumpsOf(const std::vector<double>& time,
                          const std::vector<double>& values,
                          double turn) {
  std::vector<Jump> jumps;
  if (values.size() < 4 * kSide) return jumps;
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    steps.push_back(std::abs(values[i] - values[i - 1]));
  }
  const auto ninety = steps.begin() + static_cast<std::ptrdiff_t>(0.9 * double(steps.size()));
  std::nth_element(steps.begin(), ninety, steps.end());
  const double least = std::max(kLeastJump, kLargeSteps * *ninety);
  std::vector<double> gaps;
  for (std::size_t i = 1; i < time.size(); ++i) gaps.push_back(time[i] - time[i - 1]);
  const double longest_gap = 5.0 * Median(gaps);
  for (std::size_t i = kSide; i + kSide <= values.size(); ++i) {
    if (!(std::abs(values[i] - values[i - 1]) > least) || time[i] - time[i - 1] > longest_gap) {
      continue;
    }
    const double before = Continued(std::span(values).subspan(i - kSide, kSide));
    std::vector<double> behind(values.begin() + static_cast<std::ptrdiff_t>(i),
                               values.begin() + static_cast<std::ptrdiff_t>(i + kSide));
    std::reverse(behind.begin(), behind.end());
    double size = Continued(behind) - before;
    if (turn > 0.0) size = std::remainder(size, turn);
    if (std::abs(size) > least) jumps.push_back({time[i - 1], time[i], size});
  }
  return jumps;
}

void Tell(const char* name,
          const char* unit,
          const std::vector<Jump>& jumps,
          std::vector<Finding>* findings) {
  if (jumps.empty()) return;
  const Jump& largest =
      *std::max_element(jumps.begin(), jumps.end(), [](const auto& a, const auto& b) {
        return std::abs(a.size) < std::abs(b.size);
      });
  constexpr std::size_t kMostRealignments = 2;
  findings->push_back(
      {Severity::kWarning,
       "pose_jump",
       fmt::format("pose.csv: {} jumps {}, most by {:.2g} {} at t = {:.2f} s{}.",
                   name,
                   jumps.size() == 1 ? "once" : Plural(jumps.size(), "time"),
                   largest.size,
                   unit,
                   largest.time,
                   jumps.size() > kMostRealignments
                       ? ". So many are no realignment: the tracking was lost and found again"
                       : ", and stays there"),
       FindingPlace{"pose.csv", name, {largest.before, largest.time}}});
}

}  // namespace

std::vector<Finding> CheckPoseJumps(const Log& log) {
  std::vector<Finding> findings;
  if (!log.pose) return findings;
  for (const char* axis : {"x", "y", "z"}) {
    if (const auto* values = log.pose->Find(axis)) {
      Tell(axis, "m", JumpsOf(log.pose->time, *values, 0.0), &findings);
    }
  }
  if (const auto yaw = UnwrappedYawOf(*log.pose)) {
    Tell("yaw", "rad", JumpsOf(log.pose->time, *yaw, 2.0 * std::numbers::pi), &findings);
  }
  return findings;
}

}  // namespace fathom
