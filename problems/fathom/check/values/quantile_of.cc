// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/values/quantile_of.h"

#include <algorithm>
#include <cstddef>

namespace fathom {

double QuantileOf(std::vector<double> values, double level) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(level * last);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace fathom
