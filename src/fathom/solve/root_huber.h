// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <limits>

namespace fathom {

// Huber's loss as a residual: with rho the loss, value^2 = rho(r^2), so that a sum of squares of
// root-Huber residuals is the robust cost, sample by sample. (A Ceres loss would act on a whole
// residual block, that is, on a whole stretch of the log at once.)
//
//   value = r                                        |r| <= k
//   value = sign(r) sqrt(2 k |r| - k^2)              otherwise      docs/output_error.md (3)
struct RootHuber {
  double value = 0.0;
  double derivative = 0.0;  // d value / d r

  // `r` whitened; `k` above 0, infinite for plain least squares.
  static RootHuber Of(double r, double k) {
    const double size = std::abs(r);
    if (size <= k) return {r, 1.0};
    const double root = std::sqrt(k * (2.0 * size - k));
    return {std::copysign(root, r), k / root};
  }
};

}  // namespace fathom
