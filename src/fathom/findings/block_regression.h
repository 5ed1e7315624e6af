// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace fathom {

// A linear regression over a log whose regressors are noisy too, y = X theta + e, by instruments:
//
//   Z' X theta = Z' y
//
// Z is what moves as X does, with noise of its own: least squares (Z = X) would find theta too
// small. The 95 % interval is that of the delete-one jackknife over 16 blocks of rows, by Student's
// t; it holds where a block is long against the correlation of e.
struct BlockRegression {
  Eigen::VectorXd theta;
  Eigen::VectorXd half_width;  // of the 95 % interval
  double squares = 0.0;        // the sum of e^2
};

// The rows in the order of time. Not finite where Z' X is singular, or rows are too few.
BlockRegression RegressByBlocks(const Eigen::MatrixXd& regressors,
                                const Eigen::MatrixXd& instruments,
                                const Eigen::VectorXd& observed);

}  // namespace fathom
