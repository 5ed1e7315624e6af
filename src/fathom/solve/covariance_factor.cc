// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/covariance_factor.h"

#include "fathom/solve/decompositions.h"

namespace fathom {

Eigen::MatrixXd CovarianceFactor(const Eigen::MatrixXd& covariance) {
  if (covariance.size() == 0) return covariance;
  const Eigen::VectorXd stds = covariance.diagonal().cwiseSqrt();
  const Eigen::VectorXd safe = stds.cwiseMax(1e-300);
  const Eigen::MatrixXd correlation =
      safe.cwiseInverse().asDiagonal() * covariance * safe.cwiseInverse().asDiagonal();
  const SymmetricEigen eigen = EigenOf(correlation);
  const Eigen::VectorXd roots = eigen.values.cwiseMax(0.0).cwiseSqrt();
  return stds.asDiagonal() * eigen.vectors * roots.asDiagonal();
}

}  // namespace fathom
