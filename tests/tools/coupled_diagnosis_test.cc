// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_diagnose --dofs on the log of a boat with two thrusters.

#include <filesystem>
#include <string>

#include "boat_log.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::filesystem::path BoatLog(double gain) {
  return WriteBoatLog({.starboard_gain = gain}, EmptyTestFolder() / "boat");
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

// From rest, as the boat itself began.
TEST(CoupledSimulation, RunsOverACommandAlone) {
  const std::filesystem::path log = BoatLog(1.0), folder = log.parent_path();
  const std::filesystem::path model = folder / "boat.json", out = folder / "out.csv";
  RunsWell("fathom_identify",
           {Flag("log", log), "--dofs=surge,yaw", "--structure=diagonal", Flag("model", model)});
  const CsvColumns measured = ReadColumns(log / "velocity.csv");
  std::filesystem::remove(log / "velocity.csv");
  RunsWell("fathom_simulate", {Flag("model", model), Flag("log", log), Flag("out", out)});
  const CsvColumns simulated = ReadColumns(out);
  ASSERT_EQ(simulated.rows.size(), ReadColumns(log / "command.csv").rows.size());
  const auto& at = simulated.rows[simulated.rows.size() / 2];
  const auto beside = std::ranges::min_element(
      measured.rows, {}, [&](const auto& row) { return std::abs(row.front() - at.front()); });
  EXPECT_NEAR(at[1], (*beside)[1], 0.05);
}

TEST(CoupledDiagnosis, NamesNothingOfASoundVehicle) {
  const std::filesystem::path log = BoatLog(1.0);
  const std::filesystem::path verdict = log / "verdict.json";
  RunsWell("fathom_diagnose", {Flag("log", log), "--dofs=surge,yaw", Flag("verdict", verdict)});
  EXPECT_EQ(JsonOf(verdict)["verdict"], "consistent");
}

TEST(CoupledDiagnosis, SaysWhichDofNeverMoves) {
  const std::filesystem::path log = BoatLog(1.0);
  const CsvColumns velocity = ReadColumns(log / "velocity.csv");
  std::string more = fmt::format("{},w\n", fmt::join(velocity.names, ","));
  for (const auto& row : velocity.rows) more += fmt::format("{},0\n", fmt::join(row, ","));
  WriteTestFile(log / "velocity.csv", more);
  const ToolRun run =
      RunToolBinary("fathom_diagnose", {Flag("log", log), "--dofs=surge,heave,yaw"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err,
              HasSubstr("fathom_diagnose: no diagnosis: the speed along heave never changes in "
                        "these logs; try --dofs=surge,yaw.\n"));
}

TEST(CoupledDiagnosis, DependsNotOnTheThreads) {
  const std::filesystem::path log = BoatLog(0.6);
  const auto verdict_by = [&](const std::string& threads) {
    const std::filesystem::path verdict = log / ("verdict_" + threads + ".json");
    RunsWell(
        "fathom_diagnose",
        {Flag("log", log), "--dofs=surge,yaw", "--threads=" + threads, Flag("verdict", verdict)});
    return TextOf(verdict);
  };
  EXPECT_EQ(verdict_by("1"), verdict_by("3"));
  EXPECT_THAT(
      ExpectRefusal("fathom_diagnose", {Flag("log", log), "--dofs=surge,yaw", "--threads=-1"}),
      HasSubstr("--threads: is -1, expected at least 0."));
}

TEST(CoupledDiagnosis, RefusesFlagsOfAModelOfOneDof) {
  const std::filesystem::path log = BoatLog(1.0);
  EXPECT_THAT(
      ExpectRefusal("fathom_diagnose", {Flag("log", log), "--dofs=surge,yaw", "--effort=2"}),
      HasSubstr("--effort"));
}

}  // namespace
}  // namespace fathom
