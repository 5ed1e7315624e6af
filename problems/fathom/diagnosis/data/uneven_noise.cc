// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/uneven_noise.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

constexpr std::size_t kWindow = 61;                // differences about a sample
constexpr std::size_t kFewestUnevenSamples = 300;  // for something to change over
constexpr double kUneven = 4.0;  // of variances: more than chance and any rounding make
constexpr double kMostOctaves = 12.0;

// Sizes of the fourth differences, each at its middle sample, and where these are.
struct Differences {
  std::vector<double> size;
  std::vector<std::size_t> at;
};
Differences FourthDifferences(std::span<const double> time, std::span<const double> values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  const double longest = 2.0 * 4.0 * Median(std::move(steps));
  Differences differences;
  for (std::size_t i = 2; i + 2 < values.size(); ++i) {
    if (time[i + 2] - time[i - 2] > longest) continue;
    differences.size.push_back(std::abs(values[i - 2] - 4.0 * values[i - 1] + 6.0 * values[i] -
                                        4.0 * values[i + 1] + values[i + 2]));
    differences.at.push_back(i);
  }
  return differences;
}

}  // namespace

std::vector<double> VarianceOverUsual(std::span<const double> time,
                                      std::span<const double> values) {
  if (values.size() < kFewestUnevenSamples) return {};
  const Differences differences = FourthDifferences(time, values);
  if (differences.size.size() < kFewestUnevenSamples / 2) return {};
  std::vector<double> variance;
  for (std::size_t i = 0, nearest = 0; i < values.size(); ++i) {
    while (nearest + 1 < differences.at.size() && differences.at[nearest] < i) ++nearest;
    const std::size_t first =
        std::min(nearest - std::min(nearest, kWindow / 2), differences.size.size() - kWindow);
    const auto begin = differences.size.begin() + static_cast<std::ptrdiff_t>(first);
    const double size = Median({begin, begin + static_cast<std::ptrdiff_t>(kWindow)});
    variance.push_back(size * size);
  }
  std::vector<double> sorted = variance;
  std::sort(sorted.begin(), sorted.end());
  const auto quantile = [&](double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size()))];
  };
  if (!(quantile(0.9) > kUneven * quantile(0.1)) || !(quantile(0.1) > 0.0)) return {};
  for (double& value : variance) {
    const double octaves = std::log2(std::max(value, 1e-300) / quantile(0.5));
    value = std::exp2(std::round(std::clamp(octaves, -kMostOctaves, kMostOctaves)));
  }
  return variance;
}

}  // namespace fathom
