// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace fathom {

// The standard error of the mean of values that are correlated in time, by the scatter of the means
// of 16 batches. Infinite if there are fewer than two values for each.
//
//   error^2 = sum_k (mean_k - mean)^2 / (16 * 15)
//
// It holds where a batch is long against the correlation.
double ErrorOfMean(const Eigen::ArrayXd& values);

}  // namespace fathom
