// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/row_whitener.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// The covariance of a stationary recursion of second order in closed form: Box and Jenkins 3.2.
Eigen::MatrixXd CovarianceOf(double phi1, double phi2, double variance, int n) {
  Eigen::VectorXd gamma(n);
  gamma[0] = variance * (1.0 - phi2) / ((1.0 + phi2) * ((1.0 - phi2) * (1.0 - phi2) - phi1 * phi1));
  gamma[1] = phi1 / (1.0 - phi2) * gamma[0];
  for (int k = 2; k < n; ++k) gamma[k] = phi1 * gamma[k - 1] + phi2 * gamma[k - 2];
  Eigen::MatrixXd covariance(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) covariance(i, j) = gamma[std::abs(i - j)];
  }
  return covariance;
}

TEST(RowWhitener, TurnsColouredNoiseIntoWhiteOfVarianceOne) {
  constexpr int kNum = 9;
  const RowWhitener whitener({{0.9, -0.3}, 0.04});
  RowMajorRows rows = RowMajorRows::Identity(kNum, kNum);
  whitener.Apply(rows);
  const Eigen::MatrixXd covariance = CovarianceOf(0.9, -0.3, 0.04, kNum);
  const Eigen::MatrixXd white = rows * covariance * rows.transpose();
  EXPECT_LT((white - Eigen::MatrixXd::Identity(kNum, kNum)).norm(), 1e-10);
}

TEST(RowWhitener, LeavesWhiteNoiseOfVarianceOneAlone) {
  RowMajorRows rows = RowMajorRows::Constant(5, 2, 0.3);
  const RowMajorRows before = rows;
  RowWhitener().Apply(rows);
  EXPECT_EQ(rows, before);
}

}  // namespace
}  // namespace fathom
