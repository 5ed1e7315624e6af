// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/decompositions.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kRounding = 1e-14;

// Of determinant 8; its inverse by Cramer's rule.
const Eigen::Matrix2d kMatrix = (Eigen::Matrix2d() << 4.0, 2.0, 2.0, 3.0).finished();
const Eigen::Matrix2d kInverse = (Eigen::Matrix2d() << 0.375, -0.25, -0.25, 0.5).finished();

TEST(Decompositions, SolveASymmetricSystem) {
  const Eigen::VectorXd x = SolveSymmetric(kMatrix, Eigen::Vector2d(0.0, -4.0));
  EXPECT_LT((x - Eigen::Vector2d(1.0, -2.0)).norm(), kRounding);
}

TEST(Decompositions, SolveEachColumnOfASymmetricSystem) {
  const Eigen::Matrix2d x = (Eigen::Matrix2d() << 1.0, 5.0, -2.0, 0.5).finished();
  const Eigen::Matrix2d right = (Eigen::Matrix2d() << 0.0, 21.0, -4.0, 11.5).finished();
  EXPECT_LT((SolveSymmetricColumns(kMatrix, right) - x).norm(), 10.0 * kRounding);
}

TEST(Decompositions, InvertASymmetricMatrix) {
  EXPECT_LT((InverseOfSymmetric(kMatrix) - kInverse).norm(), kRounding);
}

// The values of {{a, b}, {b, a}} are a - b and a + b, along (1, -1) and (1, 1).
TEST(Decompositions, GiveTheValuesOfASymmetricMatrixAndTheirDirections) {
  const Eigen::Matrix2d matrix = (Eigen::Matrix2d() << 2.0, 0.5, 0.5, 2.0).finished();
  const SymmetricEigen eigen = EigenOf(matrix);
  EXPECT_LT((eigen.values - Eigen::Vector2d(1.5, 2.5)).norm(), kRounding);
  EXPECT_NEAR(
      std::abs(eigen.vectors.col(0).dot(Eigen::Vector2d(1.0, -1.0))), std::sqrt(2.0), kRounding);
  EXPECT_NEAR(
      std::abs(eigen.vectors.col(1).dot(Eigen::Vector2d(1.0, 1.0))), std::sqrt(2.0), kRounding);
}

// The best constant is the mean.
TEST(Decompositions, FitLeastSquares) {
  const Eigen::Vector3d right(1.0, 2.0, 6.0);
  EXPECT_NEAR(LeastSquares(Eigen::Vector3d::Ones(), right)(0, 0), 3.0, 10.0 * kRounding);
}

}  // namespace
}  // namespace fathom
