// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/choose_window.h"
#include "fathom/signal/filters/local_polynomial.h"

#include <span>
#include <vector>

namespace fathom {

// Derivative `derivative` of `values` at every stamp, NaN where the fit fails.
std::vector<double> SavitzkyGolay(std::span<const double> time,
                                  std::span<const double> values,
                                  int derivative,
                                  const SavitzkyGolayOptions& options);

}  // namespace fathom
