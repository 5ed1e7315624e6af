// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/attitude_angles.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// A roll of 0.4 rad leaves the down at that angle; so does the same turn about any level axis, and
// a heading changes nothing.
TEST(AttitudeAngles, TiltIsTheAngleToTheUpright) {
  const double half = 0.2;
  EXPECT_NEAR(TiltOf({.attitude = {std::sin(half), 0.0, 0.0, std::cos(half)}}), 0.4, 1e-12);
  EXPECT_NEAR(
      TiltOf({.attitude = {0.6 * std::sin(half), 0.8 * std::sin(half), 0.0, std::cos(half)}}),
      0.4,
      1e-12);
  EXPECT_NEAR(TiltOf({.attitude = {0.0, 0.0, std::sin(1.1), std::cos(1.1)}}), 0.0, 1e-12);
}

// By Eigen's rotation of the bow, seen from above.
TEST(AttitudeAngles, HeadingIsWhereTheBowPoints) {
  for (const double turn : {-3.0, -0.6, 0.0, 1.2}) {
    const Eigen::Quaterniond attitude(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitX()));
    const CoupledState state = {.attitude = attitude.coeffs()};
    const Eigen::Vector3d bow = attitude * Eigen::Vector3d::UnitX();
    EXPECT_NEAR(UnwrappedHeading(state, 0.0), std::atan2(bow.y(), bow.x()), 1e-12);
    EXPECT_NEAR(UnwrappedHeading(state, 5.0), turn + 2.0 * std::numbers::pi, 1e-12);
  }
}

}  // namespace
}  // namespace fathom
