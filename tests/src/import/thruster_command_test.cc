// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Commands of thrusters become forces: by a table over pulse width and voltage, by shares, or as
// forces of the thrusters themselves.

#include "fathom/vehicle/files/thruster_command.h"

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/log/read_log.h"
#include "fathom/log/write_log.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scratch_file.h"
#include "test_folder.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

std::string VehicleWith(const std::string& command, const std::string& table) {
  return fmt::format(
      "name: two\nmass: 20\nsize: [1, 1, 1]\n"
      "thrust_tables:\n  - {{name: T, source: us, command: {}, {}}}\n"
      "thrusters:\n"
      "  - {{name: port, position: [0, -0.5, 0], direction: [1, 0, 0], thrust_table: T}}\n"
      "  - {{name: starboard, position: [0, 0.5, 0], direction: [1, 0, 0], thrust_table: T}}\n",
      command,
      table);
}

// With a dead band, weaker backwards, stronger at 16 V.
const char kTable[] =
    "voltages: [12, 16], thrust: [[1100, -30, -40], [1480, 0, 0], [1520, 0, 0], [1900, 38, 57]]";

ImportedLog ImportThrusters(const std::string& table,
                            const std::string& map,
                            const std::string& vehicle) {
  const auto file = ScratchFile("dive.csv", table);
  return ImportLog(file,
                   *OpenRecording(file),
                   ParseImportMap("map.yaml", map),
                   ParseVehicleFile("v.yaml", vehicle));
}

// Rows of a column of the command.
std::vector<double> Column(const ImportedLog& imported, const char* name) {
  return *imported.log.command->Find(name);
}

TEST(ThrusterCommand, IsForceByTheTableAtTheMeasuredVoltage) {
  const ImportedLog imported =
      ImportThrusters("t [s],a,b,battery\n0,1500,1710,14\n1,1900,1100,14\n2,0,1900,16\n",
                      "command: {unit: us, thruster_1: a, thruster_2: b, "
                      "voltage: {field: battery, unit: V}}\n",
                      VehicleWith("us", kTable));
  // 1710 us is half way from 1520 to 1900: 19 N at 12 V, 28.5 N at 16 V, 23.75 N between.
  EXPECT_THAT(Column(imported, "tau_surge"), testing::ElementsAre(23.75, 47.5 - 35, 57));
  EXPECT_THAT(*imported.log.thrusters->Find("thruster_2"), testing::ElementsAre(23.75, -35, 57));
  // Starboard to the right of the middle turns to port: -y F.
  EXPECT_THAT(Column(imported, "tau_yaw"),
              testing::ElementsAre(-0.5 * 23.75, 0.5 * 47.5 + 0.5 * 35, -0.5 * 57));
}

// A pulse of 0 is off, also of a motor that turns the other way round.
TEST(ThrusterCommand, OfAReversedMotorIsOffWhereItsPulseIs0) {
  const ImportedLog imported =
      ImportThrusters("t [s],a,b\n0,0,1500\n1,1900,1500\n2,1100,1500\n",
                      "command: {unit: us, thruster_1: {field: a, reversed: true}, thruster_2: b, "
                      "voltage: 12}\n",
                      VehicleWith("us", kTable));
  EXPECT_THAT(Column(imported, "tau_surge"), testing::ElementsAre(0, -30, 38));
}

TEST(ThrusterCommand, OfAReversedMotorChangesItsSignWhereItIsAShareOrAForce) {
  const ImportedLog shares =
      ImportThrusters("t [s],a [%],b [%]\n0,0,0\n1,50,0\n",
                      "command: {thruster_1: {field: a, reversed: true}, thruster_2: b}\n",
                      VehicleWith("1", "voltages: [16], thrust: [[-1, -40], [0, 0], [1, 50]]"));
  EXPECT_THAT(Column(shares, "tau_surge"), testing::ElementsAre(0, -20));
  const ImportedLog forces =
      ImportThrusters("t [s],a [N],b [N]\n0,0,0\n1,2,3\n",
                      "command: {thruster_1: {field: a, reversed: true}, thruster_2: b}\n",
                      VehicleWith("us", kTable));
  EXPECT_THAT(Column(forces, "tau_surge"), testing::ElementsAre(0, 1));
}

// Two topics: one at 10 Hz, the other written on change only, once.
TEST(ThrusterCommand, OfSeveralChannelsHoldsEachValueUntilTheNext) {
  std::string port = "t [s],f [N]\n";
  for (int i = 0; i < 100; ++i) port += fmt::format("{:.1f},{}\n", 0.1 * i, i);
  const auto folder = EmptyTestFolder();
  std::ofstream(folder / "port.csv") << port;
  std::ofstream(folder / "starboard.csv") << "t [s],f [N]\n0.45,100\n1.25,200\n";
  const ImportedLog imported =
      ImportLog(folder,
                *OpenRecording(folder),
                ParseImportMap("map.yaml",
                               "command: {thruster_1: {channel: port, field: f}, "
                               "thruster_2: {channel: starboard, field: f}}\n"),
                ParseVehicleFile("v.yaml", VehicleWith("us", kTable)));
  const Stream& command = *imported.log.command;
  EXPECT_EQ(command.time.front(), 0.45);
  EXPECT_EQ(command.time.size(), 95U + 2U);  // 0.5 to 9.9 s of port, and both of starboard
  const auto forces = Column(imported, "tau_surge");
  EXPECT_EQ(forces[0], 4 + 100);
  EXPECT_EQ(forces[8], 12 + 100);  // at 1.2 s
  EXPECT_EQ(forces[9], 12 + 200);  // at 1.25 s
  EXPECT_EQ(forces.back(), 99 + 200);
  EXPECT_THAT(imported.remarks, Contains(HasSubstr("starboard falls silent at 1.250 s")));
}

TEST(ThrusterCommand, TellsWhereNoVoltageIsMeasured) {
  std::string table = "t [s],a,b,battery\n";
  for (int i = 0; i < 20; ++i) {
    table += fmt::format("{},{},1500,{}\n", i, 1550 + i, i < 10 ? "14" : "");
  }
  const ImportedLog imported = ImportThrusters(table,
                                               "command: {unit: us, thruster_1: a, thruster_2: b, "
                                               "voltage: {field: battery, unit: V}}\n",
                                               VehicleWith("us", kTable));
  // From the 13th second on, over three steps behind the last.
  EXPECT_THAT(imported.remarks, Contains(HasSubstr("at 7 rows of 20 no voltage is measured")));
}

TEST(ThrusterCommand, TellsCommandsBeyondTheTable) {
  const ImportedLog imported =
      ImportThrusters("t [s],a,b\n0,1500,1500\n1,2000,1500\n2,1500,1500\n",
                      "command: {unit: us, thruster_1: a, thruster_2: b, voltage: 16}\n",
                      VehicleWith("us", kTable));
  EXPECT_THAT(Column(imported, "tau_surge"), testing::ElementsAre(0, 57, 0));
  EXPECT_THAT(imported.remarks, Contains(HasSubstr("1 row of 3 lie beyond a thrust table")));
}

// PX4 sends 900 us while it is disarmed, also to a motor that turns the other way round.
TEST(ThrusterCommand, OfADisarmedAutopilotIsOff) {
  const ImportedLog imported = ImportThrusters(
      "t [s],a,b\n0,900,900\n1,1900,1500\n2,1100,1080\n3,1500,900\n",
      "command: {unit: us, thruster_1: {field: a, reversed: true}, thruster_2: b, voltage: 12}\n",
      VehicleWith("us", kTable));
  EXPECT_THAT(Column(imported, "tau_surge"), testing::ElementsAre(0, -30, 38 - 30, 0));
  EXPECT_THAT(imported.remarks,
              testing::IsSupersetOf({HasSubstr("thruster_1: at 1 row of 4 the output is off"),
                                     HasSubstr("thruster_2: at 2 rows of 4 the output is off"),
                                     HasSubstr("1 row of 4 lie beyond a thrust table")}));
}

TEST(ThrusterCommand, MayBeAShareOfFullCommand) {
  const ImportedLog imported =
      ImportThrusters("t [s],a [%],b [%]\n0,0,0\n1,50,-100\n",
                      "command: {thruster_1: a, thruster_2: b}\n",
                      VehicleWith("1", "voltages: [16], thrust: [[-1, -40], [0, 0], [1, 50]]"));
  EXPECT_THAT(Column(imported, "tau_surge"), testing::ElementsAre(0, 25 - 40));
  EXPECT_THAT(imported.remarks, Contains(HasSubstr("the supply is taken as 16 V")));
}

TEST(ThrusterCommand, MayBeTheForceOfEachThruster) {
  const ImportedLog imported = ImportThrusters("t [s],a [kgf],b [N]\n0,0,0\n1,1,3\n",
                                               "command: {thruster_1: a, thruster_2: b}\n",
                                               VehicleWith("us", kTable));
  EXPECT_THAT(Column(imported, "tau_surge"), testing::ElementsAre(0, 9.80665 + 3));
}

// The log keeps the thrusts: OpenLog() makes the same forces of them, to the bit.
TEST(ThrusterCommand, IsWrittenInNewtonForEachThruster) {
  const auto file = ScratchFile("dive.csv", "t [s],a [N],b [N]\n0,0.1,0\n1,1,3.3\n");
  const ImportedLog imported =
      ImportLog(file,
                *OpenRecording(file),
                ParseImportMap("map.yaml", "command: {thruster_1: a, thruster_2: b}\n"),
                ParseVehicleFile("v.yaml", VehicleWith("us", kTable)));
  const std::filesystem::path folder = EmptyTestFolder();
  WriteLog(folder, [&] {
    Log log = imported.log;
    log.origin.reset();
    log.velocity = Stream{{0, 1}, {"u"}, {{0, 1}}};
    return log;
  }());
  const Log log = ReadLog(folder);
  EXPECT_EQ(log.thruster_unit, "N");
  EXPECT_THAT(*log.command->Find("thruster_2"), testing::ElementsAre(0, 3.3));
  const Stream forces =
      ForcesOfThrusts(*log.command, ParseVehicleFile("v.yaml", VehicleWith("us", kTable)));
  EXPECT_EQ(forces.values, imported.log.command->values);
}

TEST(ThrusterCommand, SaysWhatIsMissing) {
  const std::string table = "t [s],a,b\n0,1500,1500\n1,1600,1500\n";
  const auto error = [&](const char* map) {
    return ErrorFrom([&] { ImportThrusters(table, map, VehicleWith("us", kTable)); });
  };
  EXPECT_THAT(error("command: {thruster_1: a, thruster_2: b}\n"), HasSubstr("states no unit"));
  EXPECT_THAT(error("command: {unit: us, thruster_1: a, thruster_2: b}\n"),
              HasSubstr("the map to give the 'voltage'"));
  EXPECT_THAT(error("command: {unit: us, voltage: 16, thruster_1: a}\n"),
              HasSubstr("'thruster_2' is missing"));
  EXPECT_THAT(error("command: {unit: '%', voltage: 16, thruster_1: a, thruster_2: b}\n"),
              HasSubstr("has no table over a command in '1'"));
  EXPECT_THAT(error("command: {unit: knots, thruster_1: a, thruster_2: b}\n"),
              HasSubstr("is in 'knots', expected a pulse width, a share, a speed or a force"));
}

}  // namespace
}  // namespace fathom
