// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The angles of fins in the command of a map.

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <numbers>
#include <optional>
#include <string>

#include "scratch_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kFinDegree = std::numbers::pi / 180.0;

const char kFinVehicle[] =
    "name: one\nmass: 20\nsize: [1, 1, 1]\n"
    "thrusters:\n  - {name: a, position: [0, 0, 0], direction: [1, 0, 0]}\n";

Log LogWithFins(const std::string& map, const std::optional<Vehicle>& vehicle = std::nullopt) {
  const auto file = ScratchFile("dive.csv", "t [s],thrust,rudder\n0,50,-200\n1,60,20\n2,60,-10\n");
  return ImportLog(file, *OpenRecording(file), ParseImportMap("map.yaml", map), vehicle).log;
}

// A jump of over half a turn is no turn of the fin: nothing is added to its angle.
TEST(FinColumns, StandBesideForcesInTheirOwnUnit) {
  const Log log = LogWithFins(
      "command_unit: A\ncommand: {tau_surge: thrust, "
      "fin_rudder: {field: rudder, unit: deg, scale: -1}}\n");
  EXPECT_THAT(log.command->columns, ElementsAre("tau_surge"));
  EXPECT_THAT(*log.command->Find("tau_surge"), ElementsAre(50, 60, 60));
  EXPECT_THAT(
      *log.fins->Find("fin_rudder"),
      ElementsAre(
          DoubleEq(200 * kFinDegree), DoubleEq(-20 * kFinDegree), DoubleEq(10 * kFinDegree)));
  EXPECT_EQ(log.fins->time, log.command->time);
}

TEST(FinColumns, StandBesideThrusters) {
  const Log log = LogWithFins(
      "command: {fin_rudder: {field: rudder, unit: rad}, thruster_1: {field: thrust, unit: N}}\n",
      ParseVehicleFile("v.yaml", kFinVehicle));
  EXPECT_THAT(log.thrusters->columns, ElementsAre("thruster_1"));
  EXPECT_THAT(*log.command->Find("tau_surge"), ElementsAre(50, 60, 60));
  EXPECT_THAT(*log.fins->Find("fin_rudder"), ElementsAre(-200, 20, -10));
}

TEST(FinColumns, StandAloneWhereTheMapNamesTheDof) {
  const std::string command = "command: {fin_rudder: {field: rudder, unit: deg}}\n";
  const Log log = LogWithFins("dof: yaw\n" + command);
  EXPECT_FALSE(log.command.has_value());
  EXPECT_EQ(log.fins->time.size(), 3U);
  EXPECT_THAT(ErrorFrom([&] { LogWithFins(command); }),
              HasSubstr("the map's command is of fins alone, so that nothing says which DOF moves, "
                        "expected the map to name it with 'dof'"));
}

TEST(FinColumns, StandBesideShafts) {
  const Log log = LogWithFins(
      "dof: surge\ncommand: {shaft_screw: {field: thrust, unit: rpm}, "
      "fin_rudder: {field: rudder, unit: deg}}\n");
  EXPECT_FALSE(log.command.has_value());
  EXPECT_THAT(*log.shafts->Find("shaft_screw"),
              ElementsAre(DoubleEq(50.0 / 60.0), DoubleEq(1), DoubleEq(1)));
  EXPECT_THAT(*log.fins->Find("fin_rudder"), ::testing::SizeIs(3));
}

TEST(FinColumns, WithoutANameAreRefused) {
  for (const std::string key : {"fin_", "\"fin_a,b\""}) {
    EXPECT_THAT(ErrorFrom([&] { ParseImportMap("map.yaml", "command: {" + key + ": rudder}\n"); }),
                HasSubstr("expected fin_<name> in letters, digits and '_'"));
  }
}

}  // namespace
}  // namespace fathom
