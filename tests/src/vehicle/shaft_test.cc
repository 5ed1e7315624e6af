// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/shaft.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// K_T = 0.36 - 0.4 J, 0.2 m, wake 0.4.
Shaft LinearShaft() {
  Shaft shaft;
  shaft.name = "screw";
  shaft.diameter = 0.2;
  shaft.curve = OpenWaterCurve{{0.0, 0.9}, {0.36, 0.0}};
  shaft.wake = 0.4;
  shaft.thrust_deduction = 0.25;
  return shaft;
}

// By hand: 1000 * 10^2 * 0.2^4 * 0.36 = 57.6 N.
TEST(ShaftThrustAt, IsTheBollardPullAtRest) {
  EXPECT_NEAR(ShaftThrustAt(LinearShaft(), 10.0, 0.0).thrust, 57.6, 1e-12);
  EXPECT_NEAR(ShaftThrustAt(LinearShaft(), -10.0, 0.0).thrust, -57.6, 1e-12);
  EXPECT_EQ(ShaftThrustAt(LinearShaft(), 0.0, 1.3).thrust, 0.0);
}

// J = 0.6 u / (n D) = 0.9 at u = 3 m/s and 10 Hz; beyond it the propeller brakes.
TEST(ShaftThrustAt, VanishesAtTheAdvanceWhereTheCurveDoes) {
  EXPECT_NEAR(ShaftThrustAt(LinearShaft(), 10.0, 3.0).thrust, 0.0, 1e-12);
  EXPECT_NEAR(ShaftThrustAt(LinearShaft(), 10.0, 1.5).thrust, 28.8, 1e-12);
  EXPECT_NEAR(ShaftThrustAt(LinearShaft(), 10.0, 4.5).thrust, -28.8, 1e-12);
  EXPECT_NEAR(ShaftThrustAt(LinearShaft(), -10.0, -1.5).thrust, -28.8, 1e-12);
}

// J = 0.6 * 1.1 / (9 * 0.2) = 0.36667, on the line from (0.3, 0.29) to (0.7, 0.09): K_T = 0.25667.
TEST(ShaftThrustAt, FollowsATable) {
  Shaft shaft = LinearShaft();
  shaft.curve = OpenWaterCurve{{0.0, 0.3, 0.7}, {0.38, 0.29, 0.09}};
  const double K_T = 0.29 - (0.6 * 1.1 / 1.8 - 0.3) * 0.5;
  EXPECT_NEAR(ShaftThrustAt(shaft, 9.0, 1.1).thrust, 1000.0 * 81.0 * 0.0016 * K_T, 1e-10);
  // The last line goes on: J = 0.9, K_T = -0.01.
  EXPECT_NEAR(ShaftThrustAt(shaft, 9.0, 2.7).thrust, 1000.0 * 81.0 * 0.0016 * -0.01, 1e-10);
}

TEST(ShaftThrustAt, GivesTheBollardPullAgainstTheMotion) {
  const ShaftThrust at = ShaftThrustAt(LinearShaft(), -10.0, 1.5);
  EXPECT_NEAR(at.thrust, -57.6, 1e-12);
  EXPECT_EQ(at.by_speed, 0.0);
}

TEST(ShaftThrustAt, HasTheSlopeOfAFiniteDifference) {
  Shaft shaft = LinearShaft();
  shaft.curve = OpenWaterCurve{{0.0, 0.3, 0.7}, {0.38, 0.29, 0.09}};
  const double h = 1e-6;
  for (const double n : {7.0, -7.0, 0.5}) {
    for (const double u : {-1.7, -0.3, 0.2, 0.9, 2.4}) {
      const double slope =
          (ShaftThrustAt(shaft, n, u + h).thrust - ShaftThrustAt(shaft, n, u - h).thrust) / (2 * h);
      EXPECT_NEAR(ShaftThrustAt(shaft, n, u).by_speed, slope, 1e-6) << n << ' ' << u;
    }
  }
}

// K_T is then 1: what a gain multiplies.
TEST(ShaftThrustAt, CountsAnUnknownCurveAsOne) {
  Shaft shaft;
  shaft.diameter = 0.5;
  EXPECT_FALSE(shaft.IsThrustKnown());
  EXPECT_NEAR(ShaftThrustAt(shaft, 4.0, 1.0).thrust, 1000.0 * 16.0 * 0.0625, 1e-10);
}

}  // namespace
}  // namespace fathom
