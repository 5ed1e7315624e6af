// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/manoeuvre_figures.h"
#include "fathom/simulate/coupled/steering.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kShipLength = 160.93, kShipSpeed = 7.7175, kHalfSeaWater = 512.5;

std::vector<CommandedFin> RudderOfShip(const Vehicle& ship) {
  return {{ship.fins.at(0).name, ArmsOf(ship.fins.at(0)), {}}};
}

// The published derivatives, times 1e5, come back from the parts that the file splits them into.
TEST(Mariner, HasThePublishedDerivatives) {
  const Vehicle ship = ReadVehicleFile(FATHOM_DATA_DIR "/vehicles/mariner.yaml");
  const auto found = SteeringOf(*ship.coupled, RudderOfShip(ship), kShipSpeed, 0.0);
  ASSERT_TRUE(found);
  const auto primed = [&](double value, int power_of_length, int power_of_speed) {
    return 1e5 * value /
           (kHalfSeaWater * std::pow(kShipLength, power_of_length) *
            std::pow(kShipSpeed, power_of_speed));
  };
  EXPECT_NEAR(primed(found->force(0, 0), 2, 1), -1160.0, 1.0);
  EXPECT_NEAR(primed(found->force(0, 1), 3, 1), -499.0, 1.0);
  EXPECT_NEAR(primed(found->force(1, 0), 3, 1), -264.0, 1.0);
  EXPECT_NEAR(primed(found->force(1, 1), 4, 1), -166.0, 1.0);
  // To starboard, by a negative angle of theirs and ours.
  EXPECT_NEAR(primed(found->rudder[0], 2, 2), -278.0, 1.0);
  EXPECT_NEAR(primed(found->rudder[1], 3, 2), 139.0, 1.0);
  EXPECT_NEAR(primed(found->inertia(0, 0), 3, 0), 1546.0, 1.0);
  EXPECT_NEAR(primed(found->inertia(1, 1), 5, 0), 83.0, 0.1);
  EXPECT_LT(NomotoOf(*found).growth_rate, 0.0);
}

// The equations of mariner.m, integrated apart from here, give 9.2 lengths at 10 degrees, where
// their cubic terms weigh least.
TEST(Mariner, TurnsAsItsEquationsDo) {
  const Vehicle ship = ReadVehicleFile(FATHOM_DATA_DIR "/vehicles/mariner.yaml");
  ManoeuvreOptions options;
  options.ahead = kShipSpeed;
  options.force[0] = ship.coupled->quadratic_damping(0, 0) * kShipSpeed * kShipSpeed;
  options.step = 0.35;
  options.longest = 2100.0;
  const Manoeuvre circle = ParseManoeuvre("turning_circle:10");
  const auto track = RunManoeuvre(*ship.coupled, RudderOfShip(ship), circle, options);
  ASSERT_TRUE(track);
  EXPECT_NEAR(FiguresOf(circle, *track)[2].value / kShipLength, 9.2, 0.5);
}

}  // namespace
}  // namespace fathom
