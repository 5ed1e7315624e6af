// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The shapes in which spreadsheets, loggers and scripts write tables: each comes in with a map of
// at most three lines.

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "scratch_file.h"
#include "test_folder.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

// What every shape holds: a minute of thrust [N] and speed [m/s], or torque and heading.
struct Truth {
  double t, thrust, speed, heading;
};

std::vector<Truth> Rows() {
  std::vector<Truth> rows;
  for (int i = 0; i < 600; ++i) {
    const double t = 0.1 * i;
    rows.push_back({t, 10 * std::sin(t), 0.3 * std::sin(t - 0.4), 6.1 + 0.5 * std::sin(0.2 * t)});
  }
  return rows;
}

template <typename Line>
std::string Lines(const Line& line) {
  std::string text;
  for (const Truth& row : Rows()) text += line(row);
  return text;
}

std::string WithCommas(std::string text) {
  std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

constexpr char kVehicle[] =
    "name: one\nmass: 20\nsize: [1, 1, 1]\n"
    "thrust_tables:\n"
    "  - {name: T, command: us, voltages: [12, 16], thrust: [[1100, -40, -80], [1900, 40, 80]]}\n"
    "thrusters:\n"
    "  - {name: a, position: [0, 0, 0], direction: [1, 0, 0], thrust_table: T}\n";

Log Import(const std::string& name, const std::string& table, const std::string& map_text) {
  EXPECT_LE(std::count(map_text.begin(), map_text.end(), '\n'), 3);
  const auto file = ScratchFile(name, table);
  const ImportMap map = ParseImportMap("map.yaml", map_text);
  std::optional<Vehicle> vehicle;
  if (!map.vehicle.empty()) vehicle = ParseVehicleFile("v.yaml", kVehicle);
  return ImportLog(file, *OpenRecording(file, map.table), map, vehicle).log;
}

void ExpectColumn(const std::optional<Stream>& stream,
                  const char* column,
                  double start,
                  double tolerance,
                  double Truth::*truth) {
  ASSERT_TRUE(stream);
  const auto* values = stream->Find(column);
  ASSERT_NE(values, nullptr);
  const std::vector<Truth> rows = Rows();
  ASSERT_EQ(values->size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_NEAR(stream->time[i], start + rows[i].t, 1e-6);
    ASSERT_NEAR((*values)[i], rows[i].*truth, tolerance);
  }
}

void ExpectThrustAndSpeed(const Log& log, double start, double tolerance) {
  ExpectColumn(log.command, "tau_surge", start, tolerance, &Truth::thrust);
  ExpectColumn(log.velocity, "u", start, tolerance, &Truth::speed);
  EXPECT_EQ(log.dofs, std::vector<Dof>{Dof::kSurge});
}

TEST(TableShapes, SemicolonsDecimalCommasCarriageReturnsAndUnitsInBrackets) {
  const Log log =
      Import("germany.csv",
             "Zeit [ms];Schub [kN];v (cm/s)\r\n" + Lines([](const Truth& row) {
               return WithCommas(fmt::format(
                   "{:.0f};{:.9f};{:.7f}\r\n", 1000 * row.t, row.thrust / 1000, 100 * row.speed));
             }),
             "dof: surge\ncommand: {tau_surge: Schub}\nvelocity: {u: v}\n");
  ExpectThrustAndSpeed(log, 0.0, 1e-5);
}

TEST(TableShapes, BlanksCommentsAndUnitsInALineOfTheirOwn) {
  const Log log = Import(
      "logger.txt",
      "# dive 7\n# vehicle: rov\n\ntime thrust speed\ns N cm/s\n" + Lines([](const Truth& row) {
        return fmt::format("{:.2f}   {:.6f} {:.5f}\n", row.t, row.thrust, 100 * row.speed);
      }),
      "command: {tau_surge: thrust}\nvelocity: {u: speed}\n");
  ExpectThrustAndSpeed(log, 0.0, 1e-5);
}

TEST(TableShapes, DayAndTimeOfDayInTwoColumns) {
  const Log log =
      Import("spreadsheet.csv",
             "Datum;Uhrzeit;Kraft (N);u (m/s)\n" + Lines([](const Truth& row) {
               return fmt::format(
                   "03.05.2026;23:59:{:06.3f};{:.6f};{:.7f}\n", row.t, row.thrust, row.speed);
             }),
             "command: {tau_surge: Kraft}\nvelocity: {u: u}\n");
  ExpectThrustAndSpeed(log, 1777852740.0, 1e-5);
  EXPECT_EQ(*log.start, 1777852740.0);
}

// The stamp that the sender wrote, in ns since 1970, beside that of arrival.
TEST(TableShapes, StampsOfAColumnInNanosecondsThatStatesNoUnit) {
  std::string text = "t [s],sent,u [m/s]\n";
  for (int i = 0; i < 10; ++i)
    text += fmt::format("{},{},1\n", i, 1717171717000000000 + i * 100000000LL);
  const auto file = ScratchFile("dive.csv", text);
  const ImportedLog imported =
      ImportLog(file,
                *OpenRecording(file),
                ParseImportMap("map.yaml", "dof: surge\nvelocity: {time: sent, u: u}\n"),
                std::nullopt);
  EXPECT_NEAR(imported.log.velocity->time.front(), 1717171717.0, 1e-6);
  EXPECT_NEAR(imported.log.velocity->time.back(), 1717171717.9, 1e-6);
  EXPECT_THAT(imported.remarks,
              testing::Contains(testing::HasSubstr("'time: {field: sent, unit: s}'")));
}

// Whole seconds and nanoseconds, beside a column in which the latter lack their zeros.
TEST(TableShapes, StampsOfSecondsAndNanosecondsInTwoColumns) {
  std::string text = "time,secs,nsecs,u [m/s]\n";
  for (int i = 0; i < 100; ++i) {
    const int nanoseconds = i % 10 * 100000000 + 20000000;
    text += fmt::format("{0}.{1},{0},{1},{2}\n", i / 10, nanoseconds, i);
  }
  const auto file = ScratchFile("dive.csv", text);
  const auto import = [&](const std::string& time) {
    return ImportLog(file,
                     *OpenRecording(file),
                     ParseImportMap("map.yaml", "dof: surge\nvelocity: {" + time + "u: u}\n"),
                     std::nullopt);
  };
  const ImportedLog mended = import("time: {seconds: secs, nanoseconds: nsecs}, ");
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(mended.log.velocity->time[i], 0.1 * i + 0.02, 1e-9);
    EXPECT_EQ(mended.log.velocity->values[0][i], i);
  }
  EXPECT_TRUE(mended.log.origin->out_of_order.empty());
  // .02 as .20000000 lies behind .12: of each ten rows the second.
  const ImportedLog wrong = import("");
  ASSERT_EQ(wrong.log.origin->out_of_order.size(), 1U);
  EXPECT_EQ(wrong.log.origin->out_of_order[0].stream, "velocity");
  EXPECT_NEAR(wrong.log.origin->out_of_order[0].share, 0.1, 1e-12);
}

TEST(TableShapes, TwoForcesSideBySideAddUpToTheForceAhead) {
  const auto file =
      ScratchFile("run.csv",
                  ",original_timestamp,left_force,right_force,surge\n0,1717171717000,1,2,3\n"
                  "1,1717171717100,1,2,4\n2,1717171717200,2,2,5\n");
  const SuggestedMap map = SuggestMap(*OpenRecording(file), std::nullopt);
  EXPECT_THAT(map.text,
              testing::AllOf(testing::HasSubstr("The stamps are the column original_timestamp"),
                             testing::HasSubstr("  u: {field: surge, unit: m/s}")));

  const Log log =
      ImportLog(
          file, *OpenRecording(file), ParseImportMap("suggested.yaml", map.text), std::nullopt)
          .log;
  ASSERT_NE(log.command->Find("tau_surge"), nullptr);
  EXPECT_THAT(*log.command->Find("tau_surge"), testing::ElementsAre(3.0, 3.0, 4.0));
}

// As `rostopic echo -p` writes them, a topic each.
TEST(TableShapes, TablesOfOneColumnAreCalledAsTheirFiles) {
  const auto folder = EmptyTestFolder();
  const std::string rows =
      "%time,field\n1441700935804654744,3\n1441700935904654744,3\n1441700936004654744,4\n";
  for (const char* name : {"cmd.csv", "vel.csv"}) std::ofstream(folder / name) << rows;
  EXPECT_THAT(SuggestMap(*OpenRecording(folder), std::nullopt).text,
              testing::AllOf(testing::HasSubstr("  channel: cmd\n"),
                             testing::HasSubstr("  tau_surge: {field: field, unit: N}"),
                             testing::HasSubstr("  channel: vel\n"),
                             testing::HasSubstr("  u: {field: field, unit: m/s}")));
}

TEST(TableShapes, NoNamesAtAll) {
  const Log log =
      Import("matlab.txt",
             Lines([](const Truth& row) {
               return fmt::format("{:.3f}\t{:.6f}\t{:.7f}\n", 1.7e9 + row.t, row.thrust, row.speed);
             }),
             "command: {tau_surge: 2}\nvelocity: {u: 3}\n");
  ExpectThrustAndSpeed(log, 1.7e9, 1e-5);
}

TEST(TableShapes, PulseWidthsAndSeveralRatesWithEmptyCells) {
  std::string text = "timestamp,pwm,u\n";
  int i = 0;
  for (const Truth& row : Rows()) {
    text += fmt::format("{:.3f},{:.6f},\n", row.t, 1500 + 5 * row.thrust);
    if (i++ % 3 == 0) text += fmt::format("{:.3f},,{:.7f}\n", row.t + 0.01, row.speed);
  }
  // 16 V: 80 N at 400 us beyond the middle.
  const Log log = Import("pwm.csv",
                         text,
                         "vehicle: v.yaml\n"
                         "command: {unit: us, voltage: 16, thruster_1: pwm}\n"
                         "velocity: {u: u}\n");
  ExpectColumn(log.command, "tau_surge", 0.0, 1e-5, &Truth::thrust);
  ASSERT_EQ(log.velocity->time.size(), 200U);
  EXPECT_NEAR(log.velocity->time[1], 0.31, 1e-9);
  EXPECT_NEAR(log.velocity->values[0][1], Rows()[3].speed, 1e-6);
}

TEST(TableShapes, AHeadingInDegreesClockwise) {
  const Log log = Import("compass.csv",
                         "t;x;y;heading (deg);torque (Nm)\n" + Lines([](const Truth& row) {
                           const double degrees = row.heading * 180 / std::numbers::pi;
                           return fmt::format("{:.2f};{:.5f};0;{:.8f};{:.6f}\n",
                                              row.t,
                                              0.1 * row.t,
                                              std::fmod(degrees, 360.0),
                                              row.thrust);
                         }),
                         "command: {tau_yaw: torque}\npose: {x: x, y: y, yaw: heading}\n");
  ExpectColumn(log.command, "tau_yaw", 0.0, 1e-5, &Truth::thrust);
  const std::vector<Truth> rows = Rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double qz = log.pose->values[5][i];
    const double qw = log.pose->values[6][i];
    EXPECT_NEAR(
        std::remainder(2 * std::atan2(qz, qw) - rows[i].heading, 2 * std::numbers::pi), 0.0, 1e-7);
  }
}

TEST(TableShapes, EpochInMicrosecondsQuotesAndWords) {
  const Log log =
      Import("telemetry.csv",
             "\"timestamp\",\"mode\",\"cmd [%]\",\"vel (knots)\"\n" + Lines([](const Truth& row) {
               return fmt::format("{:.0f},\"MANUAL, A\",{:.6f},{:.8f}\n",
                                  1.7e15 + row.t * 1e6,
                                  row.thrust,
                                  row.speed * 3600 / 1852);
             }),
             "command_unit: \"%\"\ncommand: {tau_surge: cmd}\nvelocity: {u: 4}\n");
  ExpectThrustAndSpeed(log, 1.7e9, 1e-5);
  EXPECT_EQ(log.command_unit, "%");
}

TEST(TableShapes, AxesOfRosAndASignThatIsWrong) {
  const Log log = Import(
      "ros.csv",
      "%time,field.v.y,field.force.y\n" + Lines([](const Truth& row) {
        return fmt::format("{:.0f},{:.7f},{:.6f}\n", (1.7e9 + row.t) * 1e9, -row.speed, row.thrust);
      }),
      "dof: sway\n"
      "command: {frame: FLU, tau_sway: {field: field.force.y, scale: -1}}\n"
      "velocity: {frame: FLU, v: field.v.y}\n");
  ExpectColumn(log.command, "tau_sway", 1.7e9, 1e-5, &Truth::thrust);
  ExpectColumn(log.velocity, "v", 1.7e9, 1e-5, &Truth::speed);
}

// RFC 4180: a line break within quotes is a part of the cell.
TEST(TableShapes, ReadCellsWithLineBreaks) {
  for (const std::string end : {"\n", "\r\n"}) {
    std::string text = "\"t [s]\",\"speed, ahead [m/s]\",\"note\"" + end;
    for (int k = 0; k < 30; ++k) {
      text += std::to_string(k) + ",\"0.5\",\"two" + end + "lines, \"\"quoted\"\"\"" + end;
    }
    const auto recording = OpenRecording(ScratchFile("quote.csv", text + "1,2" + end));
    const Channel channel = recording->contents().channels.front();
    EXPECT_EQ(channel.count, 30U);
    EXPECT_EQ(channel.fields[1].name, "speed, ahead");
    EXPECT_THAT(recording->contents().remarks,
                Contains("1 row passed over, the first on line 62: expected 3 cells."));
  }
}

// Inches, and a quote that nothing closes.
TEST(TableShapes, TakeOtherQuotesForCharacters) {
  std::string text = "t [s],u [m/s],pipe\n";
  for (int k = 0; k < 30; ++k) text += std::to_string(k) + ",0.5,5\" wide\n";
  text += "30,0.5,\"open\n31,0.5,5\n";
  const auto recording = OpenRecording(ScratchFile("inches.csv", text));
  EXPECT_EQ(recording->contents().channels.front().count, 32U);
}

TEST(TableShapes, AreRefusedInUtf16WithTheCommandThatConvertsThem) {
  EXPECT_THAT(
      ErrorFrom([] { OpenRecording(ScratchFile("wide.csv", std::string("\0t\0,\0u\0\n", 8))); }),
      HasSubstr("wide.csv:1: is UTF-16, expected plain text. Convert it (iconv "));
}

}  // namespace
}  // namespace fathom
