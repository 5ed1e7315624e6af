// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Effects of the catalogue in a model of several DOFs, on logs of another simulator.

#include "fathom/coupled/structure_ladder.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <cmath>
#include <random>
#include <string>

#include "drawn_thrusters.h"
#include "drawn_vehicle.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::UnorderedElementsAre;

// An effect, and of what size it is drawn [unit of the entry].
struct DrawnEffect {
  const char* entry;
  double low, high;
};

void PrintTo(const DrawnEffect& effect, std::ostream* out) { *out << effect.entry; }

class VehicleWithAnEffect : public testing::TestWithParam<std::tuple<DrawnEffect, unsigned>> {};

// That it is named alone, and 3.3 standard deviations hold the truth: all 10 do in 99 of 100
// suites.
TEST_P(VehicleWithAnEffect, HasItNamedAlone) {
  const auto& [effect, seed] = GetParam();
  std::mt19937 random(7000 + seed);
  CoupledModel vehicle = DrawnPlanarVehicle(&random);
  const double value = std::uniform_real_distribution<double>(effect.low, effect.high)(random);
  SetValue(ParseFreeEntry(effect.entry), value, &vehicle);
  CoupledLogs logs;
  logs.data = {DrawnLog(vehicle, {}, &random)};
  const Ladder ladder = ClimbLadder(logs, vehicle.dofs, {});
  ASSERT_EQ(ladder.named.size(), 1u);
  EXPECT_EQ(NameOf(ladder.named[0].entry), effect.entry);
  EXPECT_LT(std::abs(ladder.named[0].value - value), 3.3 * ladder.named[0].std);
}

INSTANTIATE_TEST_SUITE_P(
    Drawn,
    VehicleWithAnEffect,
    testing::Combine(testing::Values(DrawnEffect{"coulomb_friction.surge", 1, 5},
                                     DrawnEffect{"cubic_damping.sway", 150, 400},
                                     DrawnEffect{"damping_asymmetry.surge", 0.5, 1.5},
                                     DrawnEffect{"thrust_dead_zone.surge", 2, 8},
                                     DrawnEffect{"thrust_asymmetry.sway", 0.15, 0.5}),
                     testing::Values(10u)));

// 200 s of a vehicle that knows its heading, in a current of about 0.15 m/s.
TEST(ACurrent, IsNamedByWhereItFlows) {
  std::mt19937 random(7201);
  const CoupledModel vehicle = DrawnPlanarVehicle(&random);
  DrawnLogOptions options;
  options.current << 0.12, -0.08, 0.0;
  CoupledLogs logs;
  logs.data = {DrawnLog(vehicle, options, &random)};
  logs.data[0].has_attitude = true;
  const Ladder ladder = ClimbLadder(logs, vehicle.dofs, {});
  ASSERT_EQ(ladder.named.size(), 2u);
  for (const NamedEntry& named : ladder.named) {
    const double truth = named.entry.row == Dof::kSurge ? 0.12 : -0.08;
    EXPECT_EQ(named.entry, CurrentEntry(named.entry.row, "drawn"));
    EXPECT_LT(std::abs(named.value - truth), 3.3 * named.std);
    EXPECT_LT(named.std, 0.002);
  }
}

// Of four logs two run in a current.
TEST(ACurrent, IsThatOfItsLog) {
  std::mt19937 random(7202);
  const CoupledModel vehicle = DrawnPlanarVehicle(&random);
  CoupledLogs logs;
  for (int k = 0; k < 4; ++k) {
    DrawnLogOptions options;
    options.duration = 60.0;
    if (k < 2) options.current << 0.15, 0.1 - 0.2 * k, 0.0;
    CoupledData& log = logs.data.emplace_back(DrawnLog(vehicle, options, &random));
    log.log = log.inputs.log = std::string("dive_") + std::to_string(k);
    log.has_attitude = true;
  }
  const Ladder ladder = ClimbLadder(logs, vehicle.dofs, {});
  std::vector<std::string> names;
  for (const NamedEntry& named : ladder.named) names.push_back(NameOf(named.entry));
  EXPECT_THAT(names,
              UnorderedElementsAre("current.north.dive_0",
                                   "current.east.dive_0",
                                   "current.north.dive_1",
                                   "current.east.dive_1"));
}

// Four logs of 60 s; through one of them a moment acts on a boat in the plane.
CoupledLogs LogsWithAMoment(double moment, unsigned seed, CoupledModel* vehicle) {
  std::mt19937 random(seed);
  *vehicle = DrawnPlanarVehicle(&random);
  CoupledLogs logs;
  for (int k = 0; k < 4; ++k) {
    CoupledModel pushed = *vehicle;
    if (k == 2) pushed.offset[Index(Dof::kYaw)] += moment;
    CoupledData& log = logs.data.emplace_back(DrawnLog(pushed, {.duration = 60.0}, &random));
    log.log = log.inputs.log = std::string("dive_") + std::to_string(k);
  }
  return logs;
}

TEST(AnOffsetOfARun, IsNamedByItsLog) {
  CoupledModel vehicle;
  const CoupledLogs logs = LogsWithAMoment(0.1, 7301, &vehicle);
  const Ladder ladder = ClimbLadder(logs, vehicle.dofs, {});
  ASSERT_EQ(ladder.named.size(), 1u);
  const NamedEntry& named = ladder.named.front();
  EXPECT_EQ(named.entry, RunOffsetEntry(Dof::kYaw, "dive_2"));
  EXPECT_LT(std::abs(named.value - 0.1), 3.3 * named.std);
  EXPECT_LT(named.std, 0.02);
}

TEST(AnOffsetOfARun, IsNotNamedWhereAllLogsAreAlike) {
  CoupledModel vehicle;
  const CoupledLogs logs = LogsWithAMoment(0.0, 7302, &vehicle);
  EXPECT_TRUE(ClimbLadder(logs, vehicle.dofs, {}).named.empty());
}

// 100 s of four thrusters, each of which was told `more` than it gave.
Ladder LadderOfTold(double (*more)(double)) {
  std::mt19937 random(7100);
  const CoupledModel vehicle = DrawnPlanarVehicle(&random);
  DrawnLogOptions options;
  options.duration = 100.0;
  CoupledLogs logs;
  logs.data = {DrawnThrusterLog(vehicle, {1.0, 1.0, 1.0, 1.0}, false, options, &random)};
  EntrySearchOptions search;
  for (CommandedThruster& thruster : logs.data[0].inputs.command.thrusters) {
    search.thrusters.push_back(thruster.name);
    for (double& thrust : thruster.thrust) thrust = more(thrust);
  }
  return ClimbLadder(logs, vehicle.dofs, search);
}

TEST(Thrusters, HaveADeadZoneThatIsNamedAlone) {
  const Ladder ladder =
      LadderOfTold([](double thrust) { return thrust + std::copysign(1.5, thrust); });
  ASSERT_EQ(ladder.named.size(), 1u);
  EXPECT_EQ(NameOf(ladder.named[0].entry), "thrust_dead_zone");
  EXPECT_NEAR(ladder.named[0].value, 1.5, 0.1);
}

TEST(Thrusters, HaveAWeaknessAsternThatIsNamedAlone) {
  const Ladder ladder =
      LadderOfTold([](double thrust) { return thrust < 0.0 ? thrust / 0.7 : thrust; });
  ASSERT_EQ(ladder.named.size(), 1u);
  EXPECT_EQ(NameOf(ladder.named[0].entry), "thrust_asymmetry");
  EXPECT_NEAR(ladder.named[0].value, 0.3, 0.02);
}

// About 100 N s^3/m^3 are little at 0.5 m/s: a friction does as well, and the text says so.
TEST(AWeakCubicDamping, IsNotToldFromAFriction) {
  std::mt19937 random(7001);
  CoupledModel vehicle = DrawnPlanarVehicle(&random);
  const FreeEntry cubic = ParseFreeEntry("cubic_damping.sway");
  SetValue(cubic, std::uniform_real_distribution<double>(50.0, 150.0)(random), &vehicle);
  CoupledLogs logs;
  logs.data = {DrawnLog(vehicle, {}, &random)};
  const Ladder ladder = ClimbLadder(logs, vehicle.dofs, {});
  ASSERT_EQ(ladder.named.size(), 1u);
  std::vector<FreeEntry> possible = ladder.named[0].not_told_apart;
  EXPECT_FALSE(possible.empty());
  possible.push_back(ladder.named[0].entry);
  EXPECT_THAT(possible, Contains(cubic));
}

// A friction in surge does nearly as well as a dead zone in yaw, as long as it is not found itself.
TEST(ADeadZone, IsToldFromAFrictionThatIsFoundAfterIt) {
  std::mt19937 random(9000);
  CoupledModel vehicle = DrawnPlanarVehicle(&random);
  SetValue(ParseFreeEntry("coulomb_friction.surge"), 1.0, &vehicle);
  SetValue(ParseFreeEntry("cubic_damping.sway"), 60.0, &vehicle);
  SetValue(ParseFreeEntry("inertia.sway.yaw"),
           0.1 * std::sqrt(vehicle.inertia(1, 1) * vehicle.inertia(5, 5)),
           &vehicle);
  SetValue(ParseFreeEntry("thrust_dead_zone.yaw"), 0.3, &vehicle);
  CoupledLogs logs;
  logs.data = {DrawnLog(vehicle, {.duration = 100.0}, &random)};
  const Ladder ladder = ClimbLadder(logs, vehicle.dofs, {});
  std::vector<std::string> names;
  for (const NamedEntry& named : ladder.named) {
    names.push_back(NameOf(named.entry));
    EXPECT_TRUE(named.not_told_apart.empty()) << names.back();
  }
  EXPECT_THAT(names, Contains("thrust_dead_zone.yaw"));
  EXPECT_THAT(names, Contains("coulomb_friction.surge"));
}

}  // namespace
}  // namespace fathom
