// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/free_entry.h"

#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/parameters.h"

#include <cmath>
#include <limits>
#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

TEST(FreeEntry, HasTheNameThatItIsReadFrom) {
  for (const std::string name : {"inertia.surge",
                                 "inertia.sway.yaw",
                                 "linear_damping.yaw",
                                 "linear_damping.yaw.sway",
                                 "quadratic_damping.heave",
                                 "quadratic_damping.yaw.sway",
                                 "righting_moment.pitch",
                                 "net_buoyancy",
                                 "offset.yaw",
                                 "offset.yaw.dive_3",
                                 "offset.heave.2026.11.30",
                                 "thrust_gain.port",
                                 "thrust_angle",
                                 "lift.yaw.sway",
                                 "fin_force.rudder",
                                 "fin_race.rudder",
                                 "fin_neutral.rudder",
                                 "fin_stuck.rudder",
                                 "fin_lag.rudder",
                                 "fin_rate_limit.rudder",
                                 "fin_stall.rudder",
                                 "time_offset",
                                 "thruster_lag",
                                 "damping_asymmetry.surge",
                                 "cubic_damping.yaw",
                                 "coulomb_friction.heave",
                                 "thrust_dead_zone.sway",
                                 "thrust_dead_zone",
                                 "thrust_asymmetry"}) {
    EXPECT_EQ(NameOf(ParseFreeEntry(name)), name);
  }
}

TEST(FreeEntry, IsAParameterOfOneDofOnTheDiagonalAlone) {
  EXPECT_EQ(ParameterOf(ParseFreeEntry("inertia.yaw")), kInertia);
  EXPECT_EQ(ParameterOf(ParseFreeEntry("offset.surge")), kBuoyancy);
  EXPECT_EQ(ParameterOf(ParseFreeEntry("net_buoyancy")), kBuoyancy);
  EXPECT_EQ(ParameterOf(ParseFreeEntry("linear_damping.sway")), kLinearDamping);
  for (const char* name : {"inertia.sway.yaw", "righting_moment.roll", "thrust_gain.port"}) {
    EXPECT_EQ(ParameterOf(ParseFreeEntry(name)), -1) << name;
  }
}

TEST(FreeEntry, OfTheInertiaIsOneNumberEitherWay) {
  const FreeEntry entry = InertiaEntry(Dof::kYaw, Dof::kSway);
  EXPECT_EQ(entry, ParseFreeEntry("inertia.sway.yaw"));
  CoupledModel model;
  SetValue(entry, 3.0, &model);
  EXPECT_EQ(model.inertia(1, 5), 3.0);
  EXPECT_EQ(model.inertia(5, 1), 3.0);
  EXPECT_EQ(ValueIn(model, entry), 3.0);
}

TEST(FreeEntry, OfTheDampingHasARowAndAColumn) {
  CoupledModel model;
  SetValue(ParseFreeEntry("linear_damping.sway.yaw"), 3.0, &model);
  EXPECT_EQ(model.linear_damping(1, 5), 3.0);
  EXPECT_EQ(model.linear_damping(5, 1), 0.0);
}

TEST(FreeEntry, OfAThrusterThatIsNotNamedIsOne) {
  EXPECT_EQ(ValueIn({}, ThrustGainEntry("port")), 1.0);
}

// A model that holds none has no entry of it.
TEST(FreeEntry, OfABoundThatIsNotThereIsInfinite) {
  CoupledModel model;
  const FreeEntry rate = FinRateLimitEntry("rudder");
  EXPECT_EQ(ValueIn(model, rate), std::numeric_limits<double>::infinity());
  SetValue(rate, ValueIn(model, rate), &model);
  EXPECT_EQ(EntriesIn(model).size(), 0u);
  SetValue(rate, 0.3, &model);
  ASSERT_EQ(EntriesIn(model).size(), 1u);
  EXPECT_EQ(EntriesIn(model)[0], rate);
  EXPECT_FALSE(MayBe(rate, 0.0));
}

// Forces in N, moments in N m.
TEST(FreeEntry, HasTheUnitOfItsRowAndColumn) {
  EXPECT_EQ(UnitOf(ParseFreeEntry("inertia.surge")), "kg");
  EXPECT_EQ(UnitOf(ParseFreeEntry("lift.sway.yaw")), "kg");
  EXPECT_EQ(UnitOf(ParseFreeEntry("lift.yaw")), "kg m");
  EXPECT_EQ(UnitOf(ParseFreeEntry("fin_force.rudder")), "kg/m");
  EXPECT_EQ(UnitOf(ParseFreeEntry("fin_neutral.rudder"), "A"), "rad");
  EXPECT_EQ(UnitOf(ParseFreeEntry("fin_stuck.rudder"), "A"), "rad");
  EXPECT_EQ(UnitOf(ParseFreeEntry("fin_stall.rudder"), "A"), "rad");
  EXPECT_EQ(UnitOf(ParseFreeEntry("fin_rate_limit.rudder"), "A"), "rad/s");
  EXPECT_EQ(UnitOf(ParseFreeEntry("inertia.sway.yaw")), "kg m");
  EXPECT_EQ(UnitOf(ParseFreeEntry("inertia.yaw")), "kg m^2");
  EXPECT_EQ(UnitOf(ParseFreeEntry("net_buoyancy")), "N");
  EXPECT_EQ(UnitOf(ParseFreeEntry("righting_moment.roll")), "N m");
  EXPECT_EQ(UnitOf(ParseFreeEntry("thrust_gain.port")), "1");
  EXPECT_EQ(UnitOf(ParseFreeEntry("thrust_angle"), "A"), "rad");
  EXPECT_EQ(UnitOf(ParseFreeEntry("thruster_lag"), "A"), "s");
  EXPECT_EQ(UnitOf(ParseFreeEntry("fin_force.rudder"), "A"), "kg/m A/N");
  EXPECT_EQ(UnitOf(ParseFreeEntry("cubic_damping.surge")), "N s^3/m^3");
  EXPECT_EQ(UnitOf(ParseFreeEntry("coulomb_friction.yaw")), "N m");
  EXPECT_EQ(UnitOf(ParseFreeEntry("thrust_dead_zone"), "A"), "A");
}

TEST(FreeEntry, OfAnEffectTakesEnergyOrThrust) {
  EXPECT_TRUE(MayBe(ParseFreeEntry("coulomb_friction.surge"), 2.0));
  EXPECT_FALSE(MayBe(ParseFreeEntry("coulomb_friction.surge"), -2.0));
  EXPECT_TRUE(MayBe(ParseFreeEntry("damping_asymmetry.surge"), -0.5));
  EXPECT_FALSE(MayBe(ParseFreeEntry("thrust_dead_zone"), -0.5));
  EXPECT_TRUE(MayBe(ParseFreeEntry("linear_damping.sway.yaw"), -0.5));
}

TEST(FreeEntry, OfABodyHasABound) {
  EXPECT_EQ(LowerBoundOf(ParseFreeEntry("linear_damping.sway")), 0.0);
  EXPECT_EQ(LowerBoundOf(ParseFreeEntry("thruster_lag")), 0.0);
  EXPECT_EQ(LowerBoundOf(ParseFreeEntry("fin_rate_limit.rudder")), 0.0);
  EXPECT_EQ(LowerBoundOf(ParseFreeEntry("damping_asymmetry.surge")), -1.0);
  EXPECT_EQ(LowerBoundOf(ParseFreeEntry("linear_damping.sway.yaw")), -INFINITY);
}

TEST(FreeEntry, IsRefusedByItsName) {
  for (const std::string name : {"inertia.up",
                                 "righting_moment.yaw",
                                 "mass",
                                 "thrust_gain.",
                                 "thrust_angle.yaw",
                                 "cubic_damping",
                                 "coulomb_friction.up",
                                 ""}) {
    EXPECT_THAT(ErrorFrom([&] { ParseFreeEntry(name); }), HasSubstr("'" + name + "'"));
  }
}

}  // namespace
}  // namespace fathom
