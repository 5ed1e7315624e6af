// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

#include <Eigen/Core>

namespace fathom {

// Signals side by side, a row for each stamp.
using SignalRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Each signal u behind a lag of first order,
//
//   T y' + y = u,   y = u at the first stamp
//
// exact for signals that are straight between their stamps. `time_constant` T [s], above 0; `time`
// strictly increasing, a stamp for each row.
SignalRows Lagged(std::span<const double> time, double time_constant, const SignalRows& signals);

}  // namespace fathom
