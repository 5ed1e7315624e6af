// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/median.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace fathom {

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double MedianStep(std::span<const double> time) {
  std::vector<double> steps;
  steps.reserve(time.size());
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  return Median(std::move(steps));
}

}  // namespace fathom
