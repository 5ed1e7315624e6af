// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/thruster.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// 0.02 N s^2 at 15 Hz: 0.02 * 225 = 4.5 N; 0.014 N s^2 at -20 Hz: -0.014 * 400 = -5.6 N.
TEST(Thruster, PushesWithTheCoefficientOfItsSense) {
  Thruster thruster;
  thruster.forward_coefficient = 0.02;
  thruster.reverse_coefficient = 0.014;
  EXPECT_NEAR(thruster.Thrust(15.0), 4.5, 1e-14);
  EXPECT_NEAR(thruster.Thrust(-20.0), -5.6, 1e-14);
  EXPECT_EQ(thruster.Thrust(0.0), 0.0);
}

// (0.3, -0.2, 0.1) x (0.6, 0, 0.8) = (-0.2*0.8 - 0.1*0, 0.1*0.6 - 0.3*0.8, 0.3*0 + 0.2*0.6)
//                                  = (-0.16, -0.18, 0.12).
TEST(AllocationMatrix, HoldsDirectionAndMomentOfEachThruster) {
  Thruster first;
  first.position = {0.3, -0.2, 0.1};
  first.direction = {0.6, 0.0, 0.8};
  Thruster starboard;  // pushes ahead from 0.25 m to starboard: turns the bow to port, yaw below 0
  starboard.position = {0.0, 0.25, 0.0};
  const auto allocation = AllocationMatrix({first, starboard});
  ASSERT_EQ(allocation.cols(), 2);
  Eigen::Matrix<double, 6, 2> expected;
  expected << 0.6, 1.0, 0.0, 0.0, 0.8, 0.0, -0.16, 0.0, -0.18, 0.0, 0.12, -0.25;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 2; ++column) {
      EXPECT_NEAR(allocation(row, column), expected(row, column), 1e-15) << row << " " << column;
    }
  }
}

// 0.1 + 0.2 - 0.3 is 5.6e-17 in doubles.
TEST(GeneralisedForces, AreZeroWhereThrustsCancel) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> allocation = Eigen::MatrixXd::Zero(6, 3);
  allocation.row(0).setOnes();
  allocation.row(1) << 0.1, 0.2, -0.3;
  const Eigen::Matrix<double, 6, 1> forces = GeneralisedForces(allocation, Eigen::Vector3d::Ones());
  EXPECT_EQ(forces(0), 3.0);
  EXPECT_EQ(forces(1), 0.0);
  EXPECT_NE(GeneralisedForces(allocation, Eigen::Vector3d(1.0, 1.0, 1.0 + 1e-9))(1), 0.0);
}

}  // namespace
}  // namespace fathom
