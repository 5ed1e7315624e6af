// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/noise_floor.h"

#include "fathom/base/median.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace fathom {

double ScatterVariance(std::span<const FreeRun> runs) {
  std::vector<double> sizes;
  for (const FreeRun& run : runs) {
    const auto miss = [&](std::size_t i) { return run.measured[i] - run.predicted[i]; };
    for (std::size_t i = 1; i + 1 < run.time.size(); ++i) {
      sizes.push_back(std::abs(miss(i - 1) - 2.0 * miss(i) + miss(i + 1)));
    }
  }
  if (sizes.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double std = 1.4826 * Median(std::move(sizes));
  return std * std / 6.0;
}

double NmaeOfScatter(std::span<const FreeRun> runs) {
  double sum = 0.0, num_samples = 0.0;
  for (const FreeRun& run : runs) {
    for (const double measured : run.measured) sum += std::abs(measured);
    num_samples += static_cast<double>(run.measured.size());
  }
  if (!(sum > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(2.0 / std::numbers::pi * ScatterVariance(runs)) * num_samples / sum;
}

}  // namespace fathom
