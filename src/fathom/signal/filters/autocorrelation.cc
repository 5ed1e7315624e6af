// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/autocorrelation.h"

#include "fathom/base/interval95.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

namespace fathom {

Autocorrelation AutocorrelationOf(std::span<const std::vector<double>> residuals,
                                  double step,
                                  std::size_t most_lags) {
  CHECK_GT(step, 0.0);
  std::size_t longest = 0, num_samples = 0;
  double squares = 0.0;
  for (const std::vector<double>& residual : residuals) {
    longest = std::max(longest, residual.size());
    num_samples += residual.size();
    for (const double e : residual) squares += e * e;
  }
  Autocorrelation result;
  if (!(squares > 0.0)) return result;
  for (std::size_t k = 1; k <= std::min(most_lags, longest / 4); ++k) {
    double products = 0.0;
    std::size_t num_products = 0;
    for (const std::vector<double>& residual : residuals) {
      for (std::size_t i = 0; i + k < residual.size(); ++i)
        products += residual[i] * residual[i + k];
      num_products += residual.size() - std::min(residual.size(), k);
    }
    result.lag.push_back(static_cast<double>(k) * step);
    result.value.push_back(products / squares);
    result.bound.push_back(kStdsOf95 * std::sqrt(static_cast<double>(num_products)) /
                           static_cast<double>(num_samples));
  }
  return result;
}

}  // namespace fathom
