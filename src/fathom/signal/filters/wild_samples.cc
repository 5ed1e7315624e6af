// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/wild_samples.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

constexpr int kReach = 5;       // neighbours on either side
constexpr double kLimit = 6.0;  // robust standard deviations

double Quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  const auto at = values.begin() + std::min<std::ptrdiff_t>(place, std::ssize(values) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Standard deviation of the usual samples. A sensor with coarse steps, or a vehicle that rests for
// half of the run, leaves a median near zero: what most samples keep to counts as well.
double UsualSpread(const std::vector<double>& sizes) {
  struct Normal {
    double share, quantile;  // of the size of a standard normal number
  };
  double spread = 0.0;
  for (const auto& [share, quantile] : {Normal{0.5, 0.6745}, {0.8, 1.2816}, {0.9, 1.6449}}) {
    spread = std::max(spread, Quantile(sizes, share) / quantile);
  }
  return spread;
}

}  // namespace

std::vector<bool> WildSamples(std::span<const double> residual, std::span<const double> variance) {
  const int n = static_cast<int>(residual.size());
  std::vector<bool> is_wild(n, false);
  if (n < 2 * kReach + 1) return is_wild;
  std::vector<double> sizes(n), neighbours;
  for (int i = 0; i < n; ++i) {
    const int first = std::clamp(i - kReach, 0, n - 2 * kReach - 1);
    const auto begin = residual.begin() + first;
    neighbours.assign(begin, begin + 2 * kReach + 1);
    const auto middle = neighbours.begin() + kReach;
    std::nth_element(neighbours.begin(), middle, neighbours.end());
    sizes[i] = std::abs(residual[i] - *middle);
    if (!variance.empty()) sizes[i] /= std::sqrt(variance[i]);
  }
  const double spread = UsualSpread(sizes);
  if (!(spread > 0.0)) return is_wild;
  for (int i = 0; i < n; ++i) is_wild[i] = sizes[i] > kLimit * spread;
  return is_wild;
}

}  // namespace fathom
