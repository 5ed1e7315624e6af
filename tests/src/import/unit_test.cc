// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/units/unit.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Unit, TurnsNumbersIntoSi) {
  EXPECT_DOUBLE_EQ(FindUnit("cm/s", Dimension::kSpeed)->factor, 0.01);
  EXPECT_DOUBLE_EQ(FindUnit("knots", Dimension::kSpeed)->factor, 0.5144444444444445);
  EXPECT_DOUBLE_EQ(FindUnit("deg", Dimension::kAngle)->factor, 0.017453292519943295);
  EXPECT_DOUBLE_EQ(FindUnit("kgf", Dimension::kForce)->factor, 9.80665);
  EXPECT_DOUBLE_EQ(FindUnit("lbf", Dimension::kForce)->factor, 0.45359237 * 9.80665);
  EXPECT_DOUBLE_EQ(FindUnit("rpm", Dimension::kRotation)->factor, 1.0 / 60.0);
  EXPECT_DOUBLE_EQ(FindUnit("rpm", Dimension::kAngularRate)->factor, 0.10471975511965977);
}

TEST(Unit, KnowsOneUnitInSeveralSpellings) {
  for (const char* text : {"m/s", "m.s^-1", "m s-1", "mps", "M/S"}) {
    ASSERT_TRUE(FindUnit(text, Dimension::kSpeed)) << text;
    EXPECT_EQ(FindUnit(text, Dimension::kSpeed)->factor, 1.0) << text;
  }
  for (const char* text : {"N m", "Nm", "N*m", "N.m"}) {
    EXPECT_TRUE(FindUnit(text, Dimension::kMoment)) << text;
  }
}

TEST(Unit, MindsCapitalsWhereTheyDecide) {
  EXPECT_DOUBLE_EQ(FindUnit("N", Dimension::kForce)->factor, 1.0);
  EXPECT_DOUBLE_EQ(FindUnit("kN", Dimension::kForce)->factor, 1e3);
  EXPECT_DOUBLE_EQ(FindUnit("mN", Dimension::kForce)->factor, 1e-3);
  EXPECT_DOUBLE_EQ(FindUnit("MN", Dimension::kForce)->factor, 1e6);
  EXPECT_FALSE(FindUnit("kn", Dimension::kForce));
  EXPECT_FALSE(FindUnit("kN", Dimension::kSpeed));
}

TEST(Unit, IsOfADimension) {
  EXPECT_FALSE(FindUnit("m", Dimension::kSpeed));
  EXPECT_FALSE(FindUnit("furlong", Dimension::kLength));
  EXPECT_EQ(FindUnit("us", Dimension::kPulse)->factor, 1.0);
  EXPECT_EQ(FindUnit("us", Dimension::kTime)->factor, 1e-6);
}

}  // namespace
}  // namespace fathom
