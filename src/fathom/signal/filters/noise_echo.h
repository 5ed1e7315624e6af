// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

#include <Eigen/Core>

namespace fathom {

// How much of the recursion y_i = phi_1 y_{i-1} + ... + phi_p y_{i-p} comes after its last rows:
// with `last` the p last ones, the oldest first, and nothing new after them, the sum of the squares
// of all rows to come is last' E last. In closed form, however long the echo. The recursion is
// stable, p is 1 at least.
Eigen::MatrixXd EchoOf(std::span<const double> coefficients);

}  // namespace fathom
