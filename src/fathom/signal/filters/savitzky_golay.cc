// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/savitzky_golay.h"

#include "fathom/signal/filters/moving_fit.h"

#include <cstddef>
#include <limits>

#include <glog/logging.h>

namespace fathom {

std::vector<double> SavitzkyGolay(std::span<const double> time,
                                  std::span<const double> values,
                                  int derivative,
                                  const SavitzkyGolayOptions& options) {
  MovingFit fit(time, {values}, options);
  std::vector<double> result(time.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (fit.MoveTo(i, derivative)) result[i] = fit.Estimate(0);
  }
  return result;
}

}  // namespace fathom
