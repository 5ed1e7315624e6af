// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/information.h"

#include "fathom/solve/decompositions.h"

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

Eigen::MatrixXd InformationOf(const MotionDerivatives& derivatives, const StampNoise& noise) {
  if (noise.colour.order() == 0) return InformationOf(derivatives, noise.velocity);
  // What the start cannot imitate, in columns of unit length.
  const PivotedQr start(derivatives.by_start);
  Eigen::MatrixXd columns = start.TransposedQTimes(derivatives.by_parameter);
  columns.topRows(start.Rank()).setZero();
  columns = start.QTimes(columns);
  const Eigen::VectorXd lengths = columns.colwise().norm();
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    if (lengths[i] > 0.0) columns.col(i) /= lengths[i];
  }
  ColouredGram coloured(noise.colour, columns.cols());
  coloured.Add(columns);
  const Eigen::MatrixXd spread = coloured.EndPiece();  // of the columns times the noise
  // In the directions that leave a trace: A B^-1 A.
  const SymmetricEigen normal = EigenOf(columns.transpose() * columns);
  const Eigen::Index num_open =
      (normal.values.array() < kSmallestPivot * normal.values.maxCoeff()).count();
  const Eigen::Index num_told = columns.cols() - num_open;
  const Eigen::MatrixXd told = normal.vectors.rightCols(num_told);
  const Eigen::VectorXd traces = normal.values.tail(num_told);
  const Eigen::MatrixXd inner =
      (told.transpose() * spread * told).llt().solve(Eigen::MatrixXd::Identity(num_told, num_told));
  const Eigen::MatrixXd scaled = told * traces.asDiagonal() * inner * traces.asDiagonal() *
                                 told.transpose() / (noise.velocity * noise.velocity);
  return lengths.asDiagonal() * scaled * lengths.asDiagonal();
}

double LogDetOf(const Eigen::MatrixXd& matrix) {
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
  return 2.0 * factor.matrixLLT().diagonal().array().log().sum();
}

double WorthOfInformation(const Eigen::MatrixXd& information, const Eigen::VectorXd& sizes) {
  const Eigen::VectorXd variances =
      InverseOf(information).diagonal().cwiseQuotient(sizes.cwiseAbs2());
  return LogDetOf(sizes.asDiagonal() * information * sizes.asDiagonal()) -
         std::log(variances.maxCoeff());
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
