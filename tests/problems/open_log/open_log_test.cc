// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/open_log/open_log.h"

#include "fathom/log/log_fingerprint.h"

#include <filesystem>
#include <fstream>
#include <string>

#include "error_from.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Two thrusters, half a metre to either side.
std::filesystem::path LogWith(const std::string& log_yaml) {
  const auto folder = TestFolder();
  std::ofstream(folder / "log.yaml") << "name: run\ndof: surge\n" << log_yaml;
  std::ofstream(folder / "command.csv") << "t,thruster_1,thruster_2\n0,3,1\n1,-2,2\n";
  std::ofstream(folder / "velocity.csv") << "t,u\n0,0\n1,0.1\n";
  std::ofstream(folder / "rov.yaml")
      << "name: rov\nthrusters:\n"
         "  - {name: port, position: [0, -0.5, 0], direction: [1, 0, 0],\n"
         "     coefficient: {forward: 2, reverse: 1}}\n"
         "  - {name: starboard, position: [0, 0.5, 0], direction: [1, 0, 0],\n"
         "     coefficient: {forward: 2, reverse: 1}}\n";
  return folder;
}

TEST(OpenLog, MakesForcesOfTheSpeedsOfThrustersAndKeepsTheThrusts) {
  const Log log = OpenLog(LogWith("vehicle: rov.yaml\n"));
  EXPECT_THAT(*log.thrusters->Find("thruster_1"), ElementsAre(18, -4));
  EXPECT_THAT(*log.thrusters->Find("thruster_2"), ElementsAre(2, 8));
  EXPECT_THAT(*log.command->Find("tau_surge"), ElementsAre(20, 4));
  EXPECT_THAT(*log.command->Find("tau_yaw"), ElementsAre(8, -6));
}

TEST(OpenLog, TakesThrustsInNewtonAsTheyAre) {
  const Log log = OpenLog(LogWith("vehicle: rov.yaml\nthruster_unit: N\n"));
  EXPECT_THAT(*log.thrusters->Find("thruster_1"), ElementsAre(3, -2));
  EXPECT_THAT(*log.command->Find("tau_surge"), ElementsAre(4, 0));
}

// `vehicle`: beside no log, so that its path is whole.
LogText ThrustersInMemory(const std::filesystem::path& vehicle) {
  LogText text;
  text.path = "memory";
  text.log_yaml = {"log.yaml", "name: run\ndof: surge\nvehicle: " + vehicle.string() + "\n"};
  text.command = LogText::File{"command", "t,thruster_1,thruster_2\n0,3,1\n1,-2,2\n"};
  text.velocity = LogText::File{"velocity", "t,u\n0,0\n1,0.1\n"};
  return text;
}

TEST(OpenLogText, MakesTheSameOfALogInMemory) {
  const std::filesystem::path folder = LogWith("vehicle: rov.yaml\n");
  const Log log = OpenLogText(ThrustersInMemory(std::filesystem::absolute(folder / "rov.yaml")));
  EXPECT_THAT(*log.thrusters->Find("thruster_1"), ElementsAre(18, -4));
  EXPECT_THAT(*log.command->Find("tau_yaw"), ElementsAre(8, -6));
  EXPECT_EQ(FingerprintOf(log), FingerprintOf(OpenLog(folder)));
}

TEST(OpenLogText, RefusesWhatTheReaderOfFoldersRefuses) {
  LogText text = ThrustersInMemory("rov.yaml");
  text.velocity->text = "t,u\n0,0\n1,nan\n";
  EXPECT_THAT(ErrorFrom([&] { OpenLogText(text); }), HasSubstr("velocity:3: column 'u' is 'nan'"));
}

TEST(OpenLog, RefusesThrustersOfAnUnknownVehicleOrUnit) {
  const auto error = [](const std::string& log_yaml) -> std::string {
    return ErrorFrom([&] { OpenLog(LogWith(log_yaml)); });
  };
  EXPECT_THAT(error(""), HasSubstr("command.csv holds thrusters, but log.yaml names no vehicle"));
  EXPECT_THAT(error("vehicle: rov.yaml\nthruster_unit: kgf\n"),
              HasSubstr("key 'thruster_unit' is 'kgf', expected Hz or N."));
}

}  // namespace
}  // namespace fathom
