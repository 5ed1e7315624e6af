// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/weak_thruster.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Thrust across, 0.11 m above the origin: 0.11 N m in roll for each newton in sway.
Thruster Lateral() { return {"lateral", {0.0, 0.0, -0.11}, {0.0, 1.0, 0.0}, 1.0, 1.0}; }
Thruster Port() { return {"port", {0.0, -0.11, 0.0}, {1.0, 0.0, 0.0}, 1.0, 1.0}; }

ActiveEffect Crosstalk(double gain, Dof partner = Dof::kSway) {
  return {FindEffect("thrust_crosstalk"), {.dof = Dof::kRoll, .partner = partner}, {gain}};
}

TEST(WeakThruster, IsTheOneThatAloneGivesThePartnersForce) {
  const std::vector<Thruster> thrusters = {Port(), Lateral()};
  const auto dead = WeakThrusterOf(Crosstalk(-0.11), 0.0022, thrusters);
  ASSERT_TRUE(dead.has_value());
  EXPECT_EQ(dead->name, "lateral");
  EXPECT_NEAR(dead->change, -1.0, 1e-12);
  EXPECT_NEAR(dead->std, 0.02, 1e-12);
  EXPECT_NEAR(WeakThrusterOf(Crosstalk(-0.033), 0.0, thrusters)->change, -0.3, 1e-12);
}

TEST(WeakThruster, IsNoneWhereAnotherCauseIsAsLikely) {
  const std::vector<Thruster> one = {Port(), Lateral()};
  EXPECT_FALSE(WeakThrusterOf(Crosstalk(0.05), 0.0, one));                // stronger
  EXPECT_FALSE(WeakThrusterOf(Crosstalk(-0.2), 0.0, one));                // the other way round
  EXPECT_FALSE(WeakThrusterOf(Crosstalk(-0.05, Dof::kSurge), 0.0, one));  // no arm in roll
  EXPECT_FALSE(WeakThrusterOf(Crosstalk(-0.11), 0.0, {}));
  const std::vector<Thruster> two = {Lateral(), Lateral()};
  EXPECT_FALSE(WeakThrusterOf(Crosstalk(-0.11), 0.0, two));
  const ActiveEffect spring = {FindEffect("position_stiffness"), {.dof = Dof::kRoll}, {-0.11}};
  EXPECT_FALSE(WeakThrusterOf(spring, 0.0, one));
}

}  // namespace
}  // namespace fathom
