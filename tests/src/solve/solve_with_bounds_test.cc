// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/solve_with_bounds.h"

#include <array>
#include <vector>

#include <ceres/autodiff_cost_function.h>
#include <ceres/problem.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Residuals x + 2 y + z - 5, x - y, 3 y + 2, z - x - 1.
struct Plane {
  template <typename T>
  bool operator()(const T* at, T* residual) const {
    residual[0] = at[0] + 2.0 * at[1] + at[2] - 5.0;
    residual[1] = at[0] - at[1];
    residual[2] = 3.0 * at[1] + 2.0;
    residual[3] = at[2] - at[0] - 1.0;
    return true;
  }
};

// A step from a trust region of radius 1e4 leaves up to 1e-4 of the way, and the cost, which falls
// with its square, shows 1e-14 of itself: 1e-7.
constexpr double kNear = 1e-7;

class BoundedSolveOfThePlane : public ::testing::TestWithParam<bool> {
 protected:
  BoundedSolveOfThePlane() {
    problem_.AddResidualBlock(
        new ceres::AutoDiffCostFunction<Plane, 4, 3>(new Plane), nullptr, at_.data());
    options_.is_dense = GetParam();
    options_.function_tolerance = 1e-14;
  }

  std::array<double, 3> at_ = {5.0, 5.0, 5.0};
  ceres::Problem problem_;
  BoundedSolveOptions options_;
};

TEST_P(BoundedSolveOfThePlane, HoldsWhatPressesOnItsBoundAndLeavesTheRestAtItsOptimum) {
  const BoundedSolve solve = SolveWithBounds(options_, {0, 1}, {}, at_.data(), &problem_);
  ASSERT_TRUE(solve.converged) << solve.message;
  // With y = 0: the normal equations 3 x = 4, 2 z = 6 of x + z - 5, x, z - x - 1.
  EXPECT_EQ(solve.held, std::vector<int>{1});
  EXPECT_NEAR(at_[0], 4.0 / 3.0, kNear);
  EXPECT_EQ(at_[1], 0.0);
  EXPECT_NEAR(at_[2], 3.0, kNear);
  // Half the squares of -2/3, 4/3, 2 and 2/3.
  EXPECT_NEAR(solve.cost, 0.5 * (4.0 + 16.0 + 36.0 + 4.0) / 9.0, 1e-12);
}

TEST_P(BoundedSolveOfThePlane, KeepsConstantsWhereTheyAre) {
  at_ = {1.0, 5.0, -2.0};
  const BoundedSolve solve = SolveWithBounds(options_, {0, 1}, {2}, at_.data(), &problem_);
  ASSERT_TRUE(solve.converged) << solve.message;
  // With z = -2: 3 x + y = 4, x + 14 y = 8 of x + 2 y - 7, x - y, 3 y + 2, -3 - x: 41 y = 20.
  EXPECT_TRUE(solve.held.empty());
  EXPECT_NEAR(at_[1], 20.0 / 41.0, kNear);
  EXPECT_NEAR(at_[0], (4.0 - 20.0 / 41.0) / 3.0, kNear);
  EXPECT_EQ(at_[2], -2.0);
}

INSTANTIATE_TEST_SUITE_P(BySparseAndDenseSteps, BoundedSolveOfThePlane, ::testing::Bool());

}  // namespace
}  // namespace fathom
