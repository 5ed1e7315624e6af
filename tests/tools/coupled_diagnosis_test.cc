// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_diagnose --dofs on the log of a boat with two thrusters.

#include <cmath>
#include <filesystem>
#include <random>
#include <string>

#include "run_tool.h"
#include "saved_files.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double kArm = 0.3;  // [m]

// A log of surge and yaw, 80 s at 20 Hz, of thrusts that step every 3 s: the starboard thruster
// gives `gain` of its command. Integrated here, without C(nu), by Euler in steps of 1 ms.
std::filesystem::path BoatLog(double gain) {
  const std::filesystem::path folder = EmptyTestFolder() / "boat";
  std::mt19937 random(5);
  std::uniform_real_distribution<double> level(-20.0, 20.0);
  std::normal_distribution<double> noise(0.0, 0.003);
  std::string command = "t,thruster_1,thruster_2\n", velocity = "t,u,r\n";
  double port = 0.0, starboard = 0.0, u = 0.0, r = 0.0;
  for (int ms = 0; ms < 80000; ++ms) {
    if (ms % 3000 == 0) {
      port = level(random);
      starboard = level(random);
      command += fmt::format("{},{},{}\n", 1e-3 * ms, port, starboard);
    }
    if (ms % 50 == 0) {
      velocity += fmt::format("{},{},{}\n", 1e-3 * ms, u + noise(random), r + noise(random));
    }
    const double force = port + gain * starboard, moment = kArm * (port - gain * starboard);
    u += 1e-3 * (force - 8.0 * u - 20.0 * u * std::abs(u)) / 40.0;
    r += 1e-3 * (moment - 3.0 * r - 4.0 * r * std::abs(r)) / 5.0;
  }
  WriteTestFile(folder / "log.yaml",
                "name: boat\ndof: [surge, yaw]\nvehicle: boat.yaml\nthruster_unit: N\n");
  WriteTestFile(folder / "boat.yaml",
                "name: boat\nmass: 30\nthrusters:\n"
                "  - {name: port, position: [0, -0.3, 0], direction: [1, 0, 0]}\n"
                "  - {name: starboard, position: [0, 0.3, 0], direction: [1, 0, 0]}\n");
  WriteTestFile(folder / "command.csv", command);
  WriteTestFile(folder / "velocity.csv", velocity);
  return folder;
}

TEST(CoupledDiagnosis, NamesTheThrusterThatIsWeak) {
  const std::filesystem::path log = BoatLog(0.6);
  const std::filesystem::path verdict = log / "verdict.json", page = log / "page.html";
  const ToolRun run = RunsWell(
      "fathom_diagnose",
      {Flag("log", log), "--dofs=surge,yaw", Flag("verdict", verdict), Flag("report", page)});
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("explained: Thruster starboard gives"), HasSubstr("next: ")));
  const auto json = JsonOf(verdict);
  EXPECT_EQ(json["verdict"], "explained");
  ASSERT_EQ(json["causes"].size(), 1);
  EXPECT_EQ(json["causes"][0]["entry"], "thrust_gain.starboard");
  EXPECT_NEAR(json["causes"][0]["value"].get<double>(), 0.6, 0.01);
  EXPECT_THAT(HeaderOf(TextOf(page)), HasSubstr("Thruster starboard gives"));

  RunsWell("fathom_simulate", {Flag("model", verdict), Flag("log", log), "--horizon=5"});
}

TEST(CoupledDiagnosis, NamesNothingOfASoundVehicle) {
  const std::filesystem::path log = BoatLog(1.0);
  const std::filesystem::path verdict = log / "verdict.json";
  RunsWell("fathom_diagnose", {Flag("log", log), "--dofs=surge,yaw", Flag("verdict", verdict)});
  EXPECT_EQ(JsonOf(verdict)["verdict"], "consistent");
}

TEST(CoupledDiagnosis, RefusesFlagsOfAModelOfOneDof) {
  const std::filesystem::path log = BoatLog(1.0);
  const ToolRun run =
      RunToolBinary("fathom_diagnose", {Flag("log", log), "--dofs=surge,yaw", "--effort=2"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("--effort"));
}

}  // namespace
}  // namespace fathom
