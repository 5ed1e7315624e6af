// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/coupled_model.h"

#include "fathom/solve/decompositions.h"

#include <cstddef>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

// The rows and columns of these DOFs.
Eigen::MatrixXd PartOf(const Matrix6& matrix, const std::vector<Dof>& dofs) {
  const auto size = static_cast<Eigen::Index>(dofs.size());
  Eigen::MatrixXd part(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) part(i, j) = matrix(Index(dofs[i]), Index(dofs[j]));
  }
  return part;
}

}  // namespace

std::optional<std::string> FinWithLagAndRateLimit(const CoupledModel& model) {
  for (const auto& [fin, rate] : model.fin_rate_limit) {
    const auto lag = model.fin_lag.find(fin);
    if (lag != model.fin_lag.end() && lag->second > 0.0) return fin;
  }
  return std::nullopt;
}

bool IsPositiveDefinite(const Matrix6& matrix, const std::vector<Dof>& dofs) {
  return Eigen::LLT<Eigen::MatrixXd>(PartOf(matrix, dofs)).info() == Eigen::Success;
}

bool IsPassive(const CoupledModel& model) {
  for (const Dof dof : model.dofs) {
    if (!(model.quadratic_damping(Index(dof), Index(dof)) >= 0.0)) return false;
  }
  const Eigen::MatrixXd linear = PartOf(model.linear_damping, model.dofs);
  const Eigen::MatrixXd symmetric = 0.5 * (linear + linear.transpose());
  const double rounding = 1e-12 * symmetric.cwiseAbs().maxCoeff();
  return LeastEigenvalue(symmetric) >= -rounding;
}

}  // namespace fathom
