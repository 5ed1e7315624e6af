// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filter_window.h"

#include "fathom/base/median.h"
#include "fathom/signal/filters/savitzky_golay.h"

#include <algorithm>

namespace fathom {
namespace {

// The window lies between these.
constexpr double kShortestWindow = 1.0;  // [s]
constexpr double kFewestSteps = 10.5;    // 11 samples
constexpr double kLongestWindow = 20.0;  // [s]
constexpr double kLongestShare = 0.1;    // of the data's duration

}  // namespace

double FilterWindowFor(std::span<const double> time,
                       std::span<const double> values,
                       std::span<const SampleRange> ranges,
                       int order) {
  const SampleRange& longest =
      *std::max_element(ranges.begin(), ranges.end(), [](const auto& a, const auto& b) {
        if (a.is_held_out != b.is_held_out) return a.is_held_out;
        return a.size() < b.size();
      });
  time = time.subspan(longest.begin, longest.size());
  values = values.subspan(longest.begin, longest.size());
  const double shortest = std::max(kShortestWindow, kFewestSteps * MedianStep(time));
  const double most = std::min(kLongestWindow, kLongestShare * (time.back() - time.front()));
  return ChooseWindow(time, values, order, shortest, std::max(shortest, most));
}

}  // namespace fathom
