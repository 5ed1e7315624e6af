// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/run_normal.h"

#include "fathom/solve/decompositions.h"

#include <limits>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr double kLeastTrace = 1e-12;  // of a direction, by that of the greatest

}  // namespace

RunNormal RunNormal::Zero(Eigen::Index num_parameters) {
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(num_parameters, num_parameters);
  return {zero, zero};
}

void RunNormal::Add(const RunNormal& other, double times) {
  A += times * other.A;
  B += times * other.B;
}

Eigen::MatrixXd RunNormal::Information() const {
  // In parameters whose columns have unit length.
  const Eigen::VectorXd lengths = A.diagonal().cwiseSqrt();
  const Eigen::VectorXd scales =
      (lengths.array() > 0.0).select(lengths.array().inverse(), 0.0).matrix();
  const Eigen::MatrixXd scaled = scales.asDiagonal() * A * scales.asDiagonal();
  const SymmetricEigen normal = EigenOf(scaled);
  const Eigen::Index num_told =
      (normal.values.array() > kLeastTrace * normal.values.maxCoeff()).count();
  const Eigen::MatrixXd told = normal.vectors.rightCols(num_told);
  const Eigen::VectorXd traces = normal.values.tail(num_told);
  const Eigen::MatrixXd spread =
      told.transpose() * scales.asDiagonal() * B * scales.asDiagonal() * told;
  const Eigen::MatrixXd inner = spread.llt().solve(Eigen::MatrixXd::Identity(num_told, num_told));
  const Eigen::MatrixXd information =
      told * traces.asDiagonal() * inner * traces.asDiagonal() * told.transpose();
  return lengths.asDiagonal() * information * lengths.asDiagonal();
}

RunNormal NormalOfRun(const MotionDerivatives& derivatives,
                      std::span<const double> stamps,
                      const std::vector<Eigen::Index>& places,
                      const RunNoise& noise) {
  const bool is_position = noise.is_position;
  const Eigen::MatrixXd& by_parameter =
      is_position ? derivatives.displacement_by_parameter : derivatives.by_parameter;
  const PivotedQr start(is_position ? derivatives.displacement_by_start : derivatives.by_start);
  Eigen::MatrixXd columns = start.TransposedQTimes(by_parameter(Eigen::all, places));
  columns.topRows(start.Rank()).setZero();
  columns = start.QTimes(columns);
  RunNormal normal = {columns.transpose() * columns, {}};
  const double variance = noise.noise.velocity * noise.noise.velocity;
  if (noise.noise.colour.order() == 0) {
    normal.B = variance * normal.A;
    return normal;
  }
  ColouredGram coloured(noise.noise.colour, columns.cols());
  normal.B = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
  for (const SampleRange& range : UnbrokenRanges(stamps)) {
    coloured.Add(columns.middleRows(static_cast<Eigen::Index>(range.begin),
                                    static_cast<Eigen::Index>(range.size())));
    normal.B += variance * coloured.EndPiece();
  }
  return normal;
}

}  // namespace fathom
