// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace fathom {

// F with F F' a covariance, so that F times independent normal numbers of variance 1 has it. It may
// be singular; what rounding leaves of it below 0 counts as 0. From the correlations, whose sizes
// are alike whatever the units.
Eigen::MatrixXd CovarianceFactor(const Eigen::MatrixXd& covariance);

}  // namespace fathom
