// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// One model on one log has one score, whichever tool tells it: all start a free run by one rule.

#include <filesystem>
#include <string>

#include "real_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include "synthesized_log.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

using Path = std::filesystem::path;

// The held-out NMAE of output error's model of a DOF, by each tool.
struct Scores {
  double identify = 0.0, compare = 0.0, diagnose = 0.0, simulate = 0.0;
};

// `logs`: with commas between them.
Scores ScoresOf(const std::string& logs, const std::string& dof, const Path& folder) {
  const auto file = [&](const char* name) { return (folder / name).string(); };
  const std::string of_log = "--log=" + logs, of_dof = "--dof=" + dof;
  RunsWell("fathom_identify", {of_log, of_dof, "--model=" + file("model.json")});
  RunsWell(
      "fathom_compare",
      {of_log, "--dofs=" + dof, "--families=output_error", "--json=" + file("comparison.json")});
  RunsWell("fathom_diagnose", {of_log, of_dof, "--verdict=" + file("verdict.json")});
  RunsWell("fathom_simulate",
           {of_log, "--model=" + file("model.json"), "--json=" + file("score.json")});
  return {JsonOf(file("model.json"))["held_out"]["nmae"],
          JsonOf(file("comparison.json"))["rows"][0]["heldout_nmae"],
          JsonOf(file("verdict.json"))["baseline"]["heldout_nmae"],
          JsonOf(file("score.json"))["held_out"]["nmae"]};
}

// Equal to many more digits than are printed; the last bits depend on the order of a sum.
void ExpectOneNumber(const Scores& scores) {
  const double rounding = 1e-10 * scores.identify;
  EXPECT_GT(scores.identify, 0.0);
  EXPECT_NEAR(scores.compare, scores.identify, rounding);
  EXPECT_NEAR(scores.diagnose, scores.identify, rounding);
  EXPECT_NEAR(scores.simulate, scores.identify, rounding);
}

class OneScore : public ::testing::TestWithParam<const char*> {};

TEST_P(OneScore, OfTheBundledLog) {
  ExpectOneNumber(ScoresOf(FATHOM_DATA_DIR "/flatfish", GetParam(), EmptyTestFolder()));
}

INSTANTIATE_TEST_SUITE_P(Dofs, OneScore, ::testing::Values("surge", "heave", "yaw"));

// fathom_simulate scores each of several logs alone.
TEST(OneScoreOfLogs, FittedTogether) {
  const Path folder = EmptyTestFolder();
  std::string logs;
  for (const int seed : {1, 2, 3}) {
    const std::string name = "run_" + std::to_string(seed);
    const Path log = SmallLogWith(folder, name, "", seed);
    WriteTestFile(log / "log.yaml", "name: " + name + "\ndof: surge\nheld_out: [70, 90]\n");
    logs += (logs.empty() ? "" : ",") + log.string();
  }
  const std::string of_logs = "--log=" + logs;
  const auto file = [&](const char* name) { return (folder / name).string(); };
  RunsWell("fathom_identify", {of_logs, "--model=" + file("model.json")});
  RunsWell("fathom_compare",
           {of_logs, "--families=output_error", "--json=" + file("comparison.json")});
  RunsWell("fathom_diagnose", {of_logs, "--verdict=" + file("verdict.json")});
  const auto model = JsonOf(file("model.json"));
  const auto row = JsonOf(file("comparison.json"))["rows"][0];
  const double score = model["held_out"]["nmae"];
  EXPECT_GT(score, 0.0);
  EXPECT_NEAR(row["heldout_nmae"].get<double>(), score, 1e-10 * score);
  EXPECT_NEAR(
      JsonOf(file("verdict.json"))["baseline"]["heldout_nmae"].get<double>(), score, 1e-10 * score);
  for (const char* parameter : {"inertia", "quadratic_damping", "linear_damping", "buoyancy"}) {
    const double std = model["parameters"][parameter]["std"];
    EXPECT_NEAR(row["parameters"][parameter]["std"].get<double>(), std, 1e-6 * std) << parameter;
  }
}

using OneScoreOnRealData = OnRealData;

TEST_F(OneScoreOnRealData, OfAMachineAndOfAVehicle) {
  for (const char* log : {"emps_pulses_velocity", "pool_rov_surge"}) {
    SCOPED_TRACE(log);
    const Path folder = EmptyTestFolder() / log;
    std::filesystem::create_directories(folder);
    ExpectOneNumber(ScoresOf((folder_ / log).string(), "surge", folder));
  }
}

}  // namespace
}  // namespace fathom
