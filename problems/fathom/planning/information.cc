// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/information.h"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

// Of the start's columns: keeps one that leaves no trace from making the rest infinite.
constexpr double kSmallestPivot = 1e-12;

Eigen::VectorXd ScalesOf(const Eigen::MatrixXd& matrix) {
  return matrix.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
}

}  // namespace

Eigen::MatrixXd InformationOf(const MotionDerivatives& derivatives, double noise) {
  const Eigen::MatrixXd& of_parameters = derivatives.by_parameter;
  const Eigen::MatrixXd& of_start = derivatives.by_start;
  Eigen::MatrixXd start = of_start.transpose() * of_start;
  start.diagonal().array() += kSmallestPivot * start.trace() + std::numeric_limits<double>::min();
  const Eigen::MatrixXd mixed = of_start.transpose() * of_parameters;
  Eigen::MatrixXd information = of_parameters.transpose() * of_parameters;
  information -= mixed.transpose() * start.llt().solve(mixed);
  return information / (noise * noise);
}

double LogDetOf(const Eigen::MatrixXd& matrix) {
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
  return 2.0 * factor.matrixLLT().diagonal().array().log().sum();
}

Eigen::MatrixXd InverseOf(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd scales = ScalesOf(matrix);
  const Eigen::MatrixXd scaled = scales.asDiagonal() * matrix * scales.asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> factor(scaled);
  if (factor.info() != Eigen::Success) {
    Eigen::MatrixXd unknown = Eigen::MatrixXd::Zero(matrix.rows(), matrix.cols());
    unknown.diagonal().setConstant(std::numeric_limits<double>::infinity());
    return unknown;
  }
  const Eigen::MatrixXd inverse =
      factor.solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
  return scales.asDiagonal() * inverse * scales.asDiagonal();
}

}  // namespace fathom
