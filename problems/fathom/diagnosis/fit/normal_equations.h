// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/whitener.h"

#include <vector>

#include <Eigen/Core>

namespace fathom {

// Normal equations of a whitened linear problem, A x = g.
struct Normal {
  Eigen::MatrixXd A;  // J' J
  Eigen::VectorXd g;  // J' r: downhill
};

// Of a Jacobian and a residual that are not whitened yet.
Normal NormalOf(const Whitener& whitener,
                const RowMajorMatrix& jacobian,
                const Eigen::VectorXd& residual);

// The step of the `free` unknowns, damped after Levenberg and Marquardt; the others stay.
Eigen::VectorXd StepOf(const Normal& normal, const std::vector<int>& free, double damping);

// Covariance of the leading `num_parameters` unknowns: the inverse of the normal matrix of the free
// ones. One that is held has the variance it would have without its bound; NaN where the data then
// tell nothing of it.
Eigen::MatrixXd CovarianceOf(const Normal& normal,
                             const std::vector<int>& free,
                             int num_parameters);

}  // namespace fathom
