// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/covariance_factor.h"

#include <Eigen/Eigenvalues>

namespace fathom {

Eigen::MatrixXd CovarianceFactor(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd stds = covariance.diagonal().cwiseSqrt();
  const Eigen::VectorXd safe = stds.cwiseMax(1e-300);
  const Eigen::MatrixXd correlation =
      safe.cwiseInverse().asDiagonal() * covariance * safe.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
  const Eigen::VectorXd roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return stds.asDiagonal() * solver.eigenvectors() * roots.asDiagonal();
}

}  // namespace fathom
