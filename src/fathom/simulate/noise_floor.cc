// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/noise_floor.h"

#include "fathom/base/robust_std.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace fathom {
namespace {

// Of the misses, without their signs.
std::vector<double> SecondDifferences(std::span<const FreeRun> runs) {
  std::vector<double> sizes;
  for (const FreeRun& run : runs) {
    const auto miss = [&](std::size_t i) { return run.measured[i] - run.predicted[i]; };
    for (std::size_t i = 1; i + 1 < run.time.size(); ++i) {
      sizes.push_back(std::abs(miss(i - 1) - 2.0 * miss(i) + miss(i + 1)));
    }
  }
  return sizes;
}

double MeanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

double ScatterVariance(std::span<const FreeRun> runs) {
  std::vector<double> sizes = SecondDifferences(runs);
  if (sizes.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double std = RobustStd(std::move(sizes));
  return std * std / 6.0;
}

double NmaeOfScatter(std::span<const FreeRun> runs) {
  const std::vector<double> sizes = SecondDifferences(runs);
  std::vector<double> measured;
  for (const FreeRun& run : runs) {
    for (const double value : run.measured) measured.push_back(std::abs(value));
  }
  if (sizes.empty() || !(MeanOf(measured) > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return MeanOf(sizes) / std::sqrt(6.0) / MeanOf(measured);
}

}  // namespace fathom
