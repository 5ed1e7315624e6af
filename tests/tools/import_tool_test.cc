// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/read_log.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "real_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Path = std::filesystem::path;

const std::string kPool = std::string(FATHOM_DATA_DIR) + "/recordings/pool.csv";
const std::string kPoolMap = std::string(FATHOM_DATA_DIR) + "/recordings/pool_map.yaml";
const std::string kBlueRov = std::string(FATHOM_DATA_DIR) + "/vehicles/bluerov2_heavy.yaml";

ToolRun Import(const std::vector<std::string>& arguments) {
  return RunToolBinary("fathom_import", arguments);
}

TEST(ImportTool, MakesALogOfASpreadsheet) {
  const Path folder = EmptyTestFolder();
  const ToolRun run =
      Import({"--from=" + kPool, "--map=" + kPoolMap, "--out=" + (folder / "pool").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(
      run.out,
      AllOf(HasSubstr("csv, 119 kB, 1 channel, 3 fields"), HasSubstr("surge: can be identified")));
  const Log log = ReadLog(folder / "pool");
  EXPECT_EQ(log.name, "pool");
  EXPECT_EQ(*log.mass, 274.0);
  EXPECT_EQ(log.origin->file, "pool.csv");
  // The first rows of the file: 0,06822 kN at 0 ms, -0,59 cm/s at 5,276 ms.
  EXPECT_DOUBLE_EQ(log.command->values[0][0], 68.22);
  EXPECT_DOUBLE_EQ(log.velocity->time[0], 0.005276);
  EXPECT_DOUBLE_EQ(log.velocity->values[0][0], -0.0059);
  EXPECT_EQ(TextOf(folder / "pool" / "map.yaml"), TextOf(kPoolMap));
  const ToolRun fit = RunToolBinary("fathom_identify", {"--log=" + (folder / "pool").string()});
  EXPECT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_THAT(fit.out, HasSubstr("surge by output error from velocity.csv: converged"));
}

TEST(ImportTool, ListsWhatAFileHolds) {
  const Path folder = EmptyTestFolder();
  const ToolRun run =
      Import({"--from=" + kPool, "--list", "--json=" + (folder / "list.json").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Time [ms], Thrust [kN], Speed [cm/s]"));
  const auto json = nlohmann::json::parse(TextOf(folder / "list.json"));
  EXPECT_EQ(json["format"], "csv");
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["channels"][0]["name"], "pool");
  EXPECT_EQ(json["channels"][0]["count"], 4800);
  EXPECT_EQ(json["channels"][0]["first"], 0.0);
  EXPECT_EQ(json["channels"][0]["fields"][2]["unit"], "cm/s");
}

// The suggested map, saved as it is, imports the file.
TEST(ImportTool, ShowsNoControlCharactersOfAForeignFile) {
  const Path folder = EmptyTestFolder();
  const Path file = folder / "a\x1b[2J.csv";
  // Text to the reader, which looks at the first 4096 bytes.
  std::ofstream(file) << "t,v [m/s]," << std::string(5000, 'x')
                      << ",tau\x1b]0;title\x07 [N]\n0,1,1,1\n1,1,2,2\n2,1,3,3\n3,2,4,4\n";
  for (const char* what : {"--list", "--suggest", "--map=none.yaml"}) {
    const ToolRun run = Import({"--from=" + file.string(), what});
    EXPECT_THAT(run.out + run.err, Not(HasSubstr("\x1b"))) << what;
    EXPECT_THAT(run.out + run.err, Not(HasSubstr("\x07"))) << what;
  }
  EXPECT_THAT(Import({"--from=" + file.string(), "--list", "--wide"}).out,
              HasSubstr("tau\\x1b]0;title\\x07"));
}

TEST(ImportTool, SuggestsAMapThatImports) {
  const Path folder = EmptyTestFolder();
  const ToolRun suggested = Import({"--from=" + kPool, "--suggest"});
  ASSERT_EQ(suggested.exit_code, 0) << suggested.err;
  EXPECT_THAT(suggested.out, AllOf(HasSubstr("tau_surge: Thrust"), HasSubstr("u: Speed")));
  const Path map = WriteTestFile(folder / "map.yaml", suggested.out);
  const ToolRun run =
      Import({"--from=" + kPool, "--map=" + map.string(), "--out=" + (folder / "pool").string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(ImportTool, TakesTheMapsOfALab) {
  const Path folder = EmptyTestFolder();
  std::filesystem::create_directory(folder / "maps");
  WriteTestFile(folder / "maps/pool.yaml",
                "when: {fields: [Thrust, Speed], ready: true}\n" + TextOf(kPoolMap));
  const std::string maps = "--maps=" + (folder / "maps").string();
  const std::string from = "--from=" + kPool;
  EXPECT_EQ(Import({from, "--suggest", maps}).out, TextOf(kPoolMap));
  const ToolRun run = Import({from, maps, "--out=" + (folder / "pool").string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const ToolRun both =
      Import({from, maps, "--map=" + kPoolMap, "--out=" + (folder / "again").string()});
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_THAT(both.err, HasSubstr("--maps: chooses a map, expected it without --map."));
}

// The same numbers as pool.csv, by the map that is suggested.
TEST(ImportTool, MakesTheSameLogOfAMat) {
  const Path folder = EmptyTestFolder();
  const std::string mat = "--from=" + std::string(FATHOM_DATA_DIR) + "/recordings/pool.mat";
  const ToolRun suggested = Import({mat, "--suggest"});
  ASSERT_EQ(suggested.exit_code, 0) << suggested.err;
  const Path map = WriteTestFile(folder / "map.yaml", suggested.out);
  const ToolRun run =
      Import({mat, "--map=" + map.string(), "--out=" + (folder / "of_mat").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ASSERT_EQ(
      Import({"--from=" + kPool, "--map=" + kPoolMap, "--out=" + (folder / "of_csv").string()})
          .exit_code,
      0);
  const Log of_mat = ReadLog(folder / "of_mat");
  const Log of_csv = ReadLog(folder / "of_csv");
  ASSERT_EQ(of_mat.velocity->time.size(), of_csv.velocity->time.size());
  for (std::size_t i = 0; i < of_mat.velocity->time.size(); ++i) {
    EXPECT_DOUBLE_EQ(of_mat.velocity->time[i], of_csv.velocity->time[i]);
    EXPECT_DOUBLE_EQ(of_mat.velocity->values[0][i], of_csv.velocity->values[0][i]);
    EXPECT_DOUBLE_EQ(of_mat.command->values[0][i], of_csv.command->values[0][i]);
  }
}

TEST(ImportTool, SaysWhichHeaderHidTheNames) {
  const Path folder = EmptyTestFolder();
  const Path file =
      WriteTestFile(folder / "run.csv", "index,t,u,tau\n0,0.1,5\n0.1,0.2,5\n0.2,0.3,5\n");
  const ToolRun run = Import({"--from=" + file.string(), "--suggest"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("line 1 has 4 names, the rows 3 cells"));
}

TEST(ImportTool, RefusesToSuggestAMapOfWhatItDoesNotKnow) {
  const Path folder = EmptyTestFolder();
  const Path file = WriteTestFile(folder / "beans.csv", "a,beans,peas\n1,2,3\n2,3,4\n3,4,5\n");
  const ToolRun run = Import({"--from=" + file.string(), "--suggest"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err,
              AllOf(HasSubstr(file.string() + ": nothing in it was recognised, expected fields"),
                    HasSubstr("tau_surge"),
                    HasSubstr("It holds a, beans, peas. "),
                    HasSubstr("--list")));
  // The import itself does not send there.
  const ToolRun import = Import({"--from=" + file.string(), "--out=" + (folder / "log").string()});
  EXPECT_EQ(import.exit_code, 1);
  EXPECT_THAT(import.err,
              AllOf(HasSubstr("It holds a, beans, peas. "), Not(HasSubstr("--suggest"))));
}

TEST(ImportTool, TellsDamageBesideTheMapThatItSuggests) {
  const Path folder = EmptyTestFolder();
  const std::string whole = TextOf(kPool);
  const Path file = WriteTestFile(folder / "cut.csv", whole.substr(0, whole.size() - 8));
  const ToolRun run = Import({"--from=" + file.string(), "--suggest"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("tau_surge: Thrust"));
  EXPECT_THAT(run.err, HasSubstr("incomplete: "));
  EXPECT_THAT(run.err, HasSubstr("note: the file ends within a row"));
}

TEST(ImportTool, SuggestsTheColumnOfTheStampsAsTheClock) {
  const ToolRun run = RunToolBinary("fathom_import", {"--from=" + kPool, "--suggest"});
  EXPECT_THAT(run.out, HasSubstr("\n# The stamps are the column Time [ms].\n"));
  EXPECT_THAT(run.out, Not(HasSubstr("not used")));
}

TEST(ImportTool, SaysHowToGetAMap) {
  const Path folder = EmptyTestFolder();
  const std::string error = ExpectRefusal(
      "fathom_import", {"--from=" + kPool, "--out=" + (folder / "l").string()}, folder);
  EXPECT_THAT(error,
              AllOf(StartsWith("fathom_import: --map: is missing"),
                    HasSubstr("fathom_import --from=" + kPool + " --suggest > map.yaml")));
}

TEST(ImportTool, RefusesWhatItCannotRead) {
  const Path folder = EmptyTestFolder();
  const Path image = WriteTestFile(folder / "image.png", std::string("\x89PNG\r\n\x1a\n\0\0", 10));
  const auto refusal = [&](const std::string& from) {
    return ExpectRefusal("fathom_import", {"--from=" + from, "--list"}, folder);
  };
  EXPECT_THAT(refusal((folder / "none.csv").string()), HasSubstr("there is no such file"));
  EXPECT_THAT(refusal(folder.string()), HasSubstr("holds no recording that can be read"));
  EXPECT_THAT(refusal(image.string()), HasSubstr("of no known format, expected a table of text"));
  EXPECT_THAT(refusal(WriteTestFile(folder / "empty.csv", "").string()), HasSubstr("is empty"));
}

TEST(ImportTool, ReplacesALogOnlyIfAsked) {
  const Path folder = EmptyTestFolder();
  const std::vector<std::string> arguments = {
      "--from=" + kPool, "--map=" + kPoolMap, "--out=" + (folder / "pool").string()};
  ASSERT_EQ(Import(arguments).exit_code, 0);
  EXPECT_THAT(Import(arguments).err, HasSubstr("expected --overwrite"));
  std::vector<std::string> overwriting = arguments;
  overwriting.emplace_back("--overwrite");
  EXPECT_EQ(Import(overwriting).exit_code, 0);
}

// Of joystick and propeller at 10 Hz; empty if it is taken.
std::string RefusalOfJoystick(const std::string& map, const std::string& vehicle = "") {
  const Path folder = EmptyTestFolder();
  std::string csv = "Time [s],Joystick [%],Motor [Hz],Speed [m/s]\n";
  for (int i = 0; i < 100; ++i) {
    csv += std::to_string(0.1 * i) + "," + std::to_string(i / 20 % 2 * 50) + "," +
           std::to_string(i / 20 % 2 * 10) + "," + std::to_string(0.01 * (i % 20)) + "\n";
  }
  std::vector<std::string> arguments = {
      "--from=" + WriteTestFile(folder / "dive.csv", csv).string(),
      "--map=" + WriteTestFile(folder / "map.yaml", map + "velocity: {u: Speed}\n").string(),
      "--out=" + (folder / "log").string()};
  if (!vehicle.empty()) {
    arguments.push_back("--vehicle=" + WriteTestFile(folder / "vehicle.yaml", vehicle).string());
  }
  const ToolRun run = Import(arguments);
  return run.exit_code == 0 ? "" : run.err;
}

TEST(ImportTool, SaysThatTheMapNamesNoCommand) {
  EXPECT_THAT(RefusalOfJoystick(""),
              HasSubstr("the map names no command, so that nothing says which DOF moves, expected "
                        "the map to name a 'command', or the DOF with 'dof'."));
}

TEST(ImportTool, TakesACommandThatIsNoForceInItsOwnUnit) {
  EXPECT_THAT(RefusalOfJoystick("command: {tau_surge: Joystick}\n"),
              AllOf(HasSubstr("is in '%', expected a force for 'tau_surge': 'N', 'kN'"),
                    HasSubstr("is taken as it is with 'command_unit: \"%\"'")));
  EXPECT_EQ(RefusalOfJoystick("command: {tau_surge: Joystick}\ncommand_unit: \"%\"\n"), "");
}

TEST(ImportTool, AsksForTheThrustersOfAVehicleFileThatHasNone) {
  EXPECT_THAT(RefusalOfJoystick("command: {thruster_1: Motor}\n", "name: bd\n"),
              HasSubstr("the vehicle file of 'bd' has no thrusters yet. Fill them in"));
}

// A user holds out what fathom_check proposes, then mends the map.
TEST(ImportTool, KeepsWhatTheLogBeforeHoldsOut) {
  const Path folder = EmptyTestFolder();
  std::string map = TextOf(kPoolMap);
  const auto line = map.find("held_out");
  ASSERT_NE(line, std::string::npos);
  map.erase(line, map.find('\n', line) - line);
  WriteTestFile(folder / "map.yaml", map);
  const std::vector<std::string> arguments = {"--from=" + kPool,
                                              "--map=" + (folder / "map.yaml").string(),
                                              "--out=" + (folder / "pool").string(),
                                              "--overwrite"};
  ASSERT_EQ(Import(arguments).exit_code, 0);
  std::string log = TextOf(folder / "pool/log.yaml");
  WriteTestFile(folder / "pool/log.yaml", log + "held_out: [100, 120]\n");
  const ToolRun run = Import(arguments);
  EXPECT_THAT(run.out, HasSubstr("note: held_out is kept from the log.yaml before"));
  const Log again = ReadLog(folder / "pool");
  ASSERT_EQ(again.held_out.size(), 1U);
  EXPECT_EQ(again.held_out[0].from, 100.0);
  EXPECT_EQ(again.held_out[0].to, 120.0);
}

TEST(ImportTool, RefusesADamagedFileWithoutOneSoundMessage) {
  const Path folder = EmptyTestFolder();
  const std::string from =
      "--from=" +
      WriteTestFile(folder / "a.bag", "#ROSBAG V2.0\n" + std::string(4096, '\0')).string();
  const ToolRun run = Import({from, "--list"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("is damaged and holds no sound message"));
}

// Nanoseconds without their leading zeros: .02 s is written as .20000000.
TEST(ImportTool, WarnsOfStampsOutOfOrderAndMendsThemWhenTold) {
  const Path folder = EmptyTestFolder();
  std::string csv = "time,secs,nsecs,tau,u\n";
  for (int i = 0; i < 300; ++i) {
    const std::string second = std::to_string(i / 10);
    const std::string nanoseconds = std::to_string(i % 10 * 100000000 + 20000000);
    csv += second + "." + nanoseconds + "," + second + "," + nanoseconds + "," +
           std::to_string(i / 40 % 2 * 10) + "," + std::to_string(0.01 * (i % 40)) + "\n";
  }
  WriteTestFile(folder / "dive.csv", csv);
  const auto import = [&](const std::string& time) {
    return Import({"--from=" + (folder / "dive.csv").string(),
                   "--map=" + WriteTestFile(folder / "map.yaml",
                                            "command: {" + time + "tau_surge: tau}\n" +
                                                "velocity: {" + time + "u: u}\n")
                                  .string(),
                   "--out=" + (folder / "log").string(),
                   "--overwrite"});
  };
  const ToolRun wrong = import("");
  EXPECT_EQ(wrong.exit_code, 0);
  EXPECT_THAT(wrong.err, HasSubstr("10 % of the stamps of the velocity lay before an earlier one"));
  EXPECT_THAT(wrong.out, HasSubstr("have 8 to 9 digits behind the point"));
  const ToolRun mended = import("time: {seconds: secs, nanoseconds: nsecs}, ");
  EXPECT_EQ(mended.exit_code, 0);
  EXPECT_THAT(mended.err, Not(HasSubstr("lay before an earlier one")));
}

// Nothing that no program would read.
TEST(ImportTool, WritesNoLogWhoseCameraFilesAreNone) {
  const Path folder = EmptyTestFolder();
  WriteTestFile(folder / "dive.csv", "t,tau,u\n0,0,0\n0.1,1,0.1\n0.2,0,0.2\n");
  WriteTestFile(folder / "secret.txt", "root:x:0:0\n");
  const ToolRun run = Import({"--from=" + (folder / "dive.csv").string(),
                              "--map=" + WriteTestFile(folder / "map.yaml",
                                                       "command: {tau_surge: tau}\n"
                                                       "camera: {video: secret.txt, calibration: "
                                                       "secret.txt, tags: secret.txt, mount: "
                                                       "secret.txt}\n")
                                             .string(),
                              "--out=" + (folder / "log").string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "log"));
  EXPECT_THAT(run.err, Not(HasSubstr("root")));
}

class ImportToolOnRealLogs : public OnRealData {};

// A vehicle with the first six of eight thrusters: the log drives so many.
Path SixThrusters(const Path& folder) {
  std::string text = TextOf(kBlueRov);
  text.resize(text.find("  - {name: rear_starboard_vertical"));
  return WriteTestFile(folder / "six.yaml", text);
}

TEST_F(ImportToolOnRealLogs, TakesAnArduSubLogWithAVehicleAlone) {
  const Path folder = EmptyTestFolder();
  const std::string from =
      "--from=" + (folder_ / "formats" / "bin" / "ardusub_4.5_sitl_visp.BIN").string();
  const std::string out = "--out=" + (folder / "log").string();
  EXPECT_THAT(Import({from, out}).err, HasSubstr("Or give --vehicle"));
  // A log of six outputs does not go with eight thrusters.
  EXPECT_THAT(Import({from, out, "--vehicle=" + kBlueRov}).err,
              AllOf(StartsWith("fathom_import: --vehicle="),
                    HasSubstr("the log drives 6 outputs, and the vehicle 'BlueROV2 heavy' has 8 "
                              "thrusters"),
                    HasSubstr("--suggest > map.yaml")));
  // Nor with a vehicle file without thrusters.
  EXPECT_THAT(Import({from, out, "--vehicle=" FATHOM_DATA_DIR "/vehicles/bluerov2.yaml"}).err,
              HasSubstr("the log drives 6 outputs, and the vehicle 'BlueROV2' has 0 thrusters"));
  const ToolRun suggested =
      RunToolBinary("fathom_import", {from, "--suggest", "--vehicle=" + kBlueRov});
  EXPECT_THAT(suggested.out,
              AllOf(HasSubstr("\nvehicle: vehicle.yaml"),
                    HasSubstr("thruster_6: "),
                    Not(HasSubstr("thruster_7")),
                    HasSubstr("this map cannot be imported with it")));
  const ToolRun run = Import({from, out, "--vehicle=" + SixThrusters(folder).string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("incomplete: 1200096 of 1200128 bytes are sound"));
  const Log log = ReadLog(folder / "log");
  EXPECT_EQ(log.command->time.size(), 266U);
  EXPECT_EQ(log.vehicle, "six.yaml");
}

TEST_F(ImportToolOnRealLogs, TakesATelemetryLogWithAVehicleAlone) {
  const Path folder = EmptyTestFolder();
  const std::string from = "--from=" + (folder_ / "formats" / "ardusub_small.tlog").string();
  const std::string out = "--out=" + (folder / "log").string();
  EXPECT_THAT(Import({from, out}).err, HasSubstr("Or give --vehicle"));
  const ToolRun run = Import({from, out, "--vehicle=" + kBlueRov});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Log log = ReadLog(folder / "log");
  EXPECT_TRUE(log.command && log.velocity && log.pose);
}

TEST_F(ImportToolOnRealLogs, SuggestsAMapForAPx4Log) {
  const std::string from =
      "--from=" + (folder_ / "formats" / "ulog" / "sample_log_small.ulg").string();
  const ToolRun run = Import({from, "--suggest"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("channel: \"actuator_outputs\""),
                    HasSubstr("channel: \"vehicle_local_position\""),
                    HasSubstr("channel: \"vehicle_attitude\", field: \"q[3]\"")));
}

// Stamps in ms that no name calls so: the note that says how to mend the map comes along.
TEST(ImportTool, NamesTheFileAndTheNotesOfALogThatCannotBeRead) {
  const Path folder = EmptyTestFolder();
  std::string rows = "t,tau,v\n";
  for (int k = 0; k < 50; ++k) {
    rows += std::to_string(100 * k) + "," + std::to_string(k % 7) + ",0." + std::to_string(k % 5) +
            "\n";
  }
  const Path csv = WriteTestFile(folder / "ms.csv", rows);
  const Path map = WriteTestFile(folder / "m.yaml",
                                 "dof: surge\n"
                                 "command: {tau_surge: {field: tau, unit: N}}\n"
                                 "velocity: {u: {field: v, unit: m/s}}\n");
  EXPECT_THAT(
      ExpectRefusal(
          "fathom_import",
          {"--from=" + csv.string(), "--map=" + map.string(), "--out=" + (folder / "log").string()},
          folder),
      AllOf(StartsWith("fathom_import: " + csv.string() + ": makes a log that cannot"),
            HasSubstr("The log was not written: mend " + map.string()),
            HasSubstr("the map: 'table: {time_unit: ms}'")));
}

}  // namespace
}  // namespace fathom
