// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/thrust_table.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

ThrustTable SmallTable() {
  return {.name = "small",
          .command_unit = "us",
          .voltages = {12.0, 16.0},
          .commands = {1100.0, 1300.0, 1470.0, 1520.0, 1700.0, 1900.0},
          .thrust = {
              {-30.0, -42.0}, {-11.0, -15.0}, {0.0, 0.0}, {0.0, 0.0}, {14.0, 19.0}, {35.0, 50.0}}};
}

TEST(ThrustTable, GivesTheCommandOfAThrust) {
  const ThrustTable table = SmallTable();
  for (const double voltage : {12.0, 13.7, 16.0}) {
    for (const double thrust : {-30.0, -17.3, -11.0, -0.4, 0.7, 14.0, 23.9, 35.0}) {
      const auto command = table.CommandFor(thrust, voltage);
      ASSERT_TRUE(command) << thrust << " N at " << voltage << " V";
      EXPECT_NEAR(table.Thrust(*command, voltage), thrust, 1e-9);
    }
  }
  // By hand, at 16 V: 1700 + (25 - 19) / (50 - 19) 200.
  EXPECT_NEAR(*table.CommandFor(25.0, 16.0), 1738.709677, 1e-6);
}

TEST(ThrustTable, StopsInTheMiddleOfItsDeadZone) {
  EXPECT_DOUBLE_EQ(*SmallTable().CommandFor(0.0, 14.0), 1495.0);
}

TEST(ThrustTable, GivesNoCommandBeyondItsEnds) {
  EXPECT_FALSE(SmallTable().CommandFor(35.1, 12.0));
  EXPECT_TRUE(SmallTable().CommandFor(35.1, 16.0));
  EXPECT_FALSE(SmallTable().CommandFor(-42.1, 16.0));
}

TEST(ThrustTable, GivesTheCommandOfAPropellerThatIsTurnedRound) {
  ThrustTable table = SmallTable();
  for (auto& row : table.thrust) {
    for (double& thrust : row) thrust = -thrust;
  }
  EXPECT_NEAR(*table.CommandFor(-25.0, 16.0), 1738.709677, 1e-6);
  EXPECT_DOUBLE_EQ(*table.CommandFor(0.0, 14.0), 1495.0);
}

TEST(ThrustTable, GivesNoCommandWhereThrustRisesAndFalls) {
  ThrustTable table = SmallTable();
  table.thrust[1] = {-31.0, -43.0};
  EXPECT_FALSE(table.CommandFor(5.0, 12.0));
}

}  // namespace
}  // namespace fathom
