// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/least_squares/regression.h"

#include "fathom/signal/filters/autoregression.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glog/logging.h>

namespace fathom {
namespace {

struct Row {
  double acceleration, velocity, square, force;

  bool IsFinite() const {
    return std::isfinite(acceleration) && std::isfinite(velocity) && std::isfinite(square) &&
           std::isfinite(force);
  }
};

}  // namespace

Regression RegressionOf(std::span<const Segment> segments) {
  Regression regression;
  std::vector<Row> rows;
  for (const Segment& segment : segments) {
    CHECK_EQ(segment.acceleration.size(), segment.smoothed_velocity.size());
    CHECK_EQ(segment.acceleration.size(), segment.smoothed_force.size());
    bool inside = false;
    for (size_t i = 0; i < segment.acceleration.size(); ++i) {
      const double v = segment.smoothed_velocity[i];
      const double square =
          segment.smoothed_square.empty() ? v * std::abs(v) : segment.smoothed_square[i];
      const Row row = {segment.acceleration[i], v, square, segment.smoothed_force[i]};
      if (row.IsFinite() && !inside) {
        regression.piece_begin.push_back(static_cast<Eigen::Index>(rows.size()));
      }
      inside = row.IsFinite();
      if (inside) rows.push_back(row);
    }
  }
  const auto n = static_cast<Eigen::Index>(rows.size());
  regression.piece_begin.push_back(n);
  regression.F.resize(n, 4);
  regression.acceleration.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    regression.acceleration[i] = rows[i].acceleration;
    regression.F.row(i) << rows[i].force, rows[i].square, rows[i].velocity, 1.0;
  }
  return regression;
}

Eigen::Matrix4d CovarianceOf(const Regression& regression,
                             const Eigen::VectorXd& residual,
                             const Eigen::Matrix4d& inverse_gram,
                             int max_order) {
  const auto& begin = regression.piece_begin;
  std::vector<std::vector<double>> pieces;
  for (size_t k = 0; k + 1 < begin.size(); ++k) {
    pieces.emplace_back(residual.data() + begin[k], residual.data() + begin[k + 1]);
  }
  // An order that the data can carry.
  const int order = std::min(max_order, static_cast<int>(residual.size() / 10));
  const Autoregression noise = FitAutoregression(std::move(pieces), order);
  ColouredGram coloured(noise, 4);
  Eigen::Matrix4d gram = Eigen::Matrix4d::Zero();
  for (size_t k = 0; k + 1 < begin.size(); ++k) {
    coloured.Add(regression.F.middleRows(begin[k], begin[k + 1] - begin[k]));
    gram += coloured.EndPiece();
  }
  const auto n = static_cast<double>(residual.size());
  return n / (n - 4.0) * inverse_gram * gram * inverse_gram;
}

ParameterVector ParametersOf(const Eigen::Vector4d& lumped) {
  return ParameterVector(1.0, -lumped[1], -lumped[2], -lumped[3]) / lumped[0];
}

Eigen::Matrix4d ParameterJacobian(const Eigen::Vector4d& lumped) {
  const double alpha = lumped[0];
  Eigen::Matrix4d J = Eigen::Matrix4d::Zero();
  J.col(0) = -ParametersOf(lumped) / alpha;
  for (int k = 1; k < 4; ++k) J(k, k) = -1.0 / alpha;
  return J;
}

}  // namespace fathom
