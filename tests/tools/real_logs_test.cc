// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The tools on logs of real vehicles.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "real_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

class RealLogsTool : public OnRealData {
 protected:
  std::string Log(const std::string& name) const { return Flag("log", folder_ / name); }
};

// A single tone of 0.2 rad/s: good predictions of the same tone, and honest about the rest.
TEST_F(RealLogsTool, LbvSurgeIsPredictedAndItsAmbiguityIsSaid) {
  const ToolRun run = RunsWell("fathom_identify",
                               {Log("lbv_surge"), "--velocity=author_velocity.csv", "--dof=surge"});
  EXPECT_LE(NumberBehind("NMAE ", run.out, "held out"), 0.065);
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("surge by output error from author_velocity.csv: "),
                    HasSubstr("This log cannot separate inertia, damping and a command delay"),
                    AnyOf(HasSubstr("square wave"), HasSubstr("several tones"))));
  EXPECT_THAT(run.err, HasSubstr("author_velocity.csv: 12 further columns are not read"));
}

// Poses from one tag, which flips between its two solutions: every family has to say something.
TEST_F(RealLogsTool, LbvSurgeRunsFromItsPoses) {
  const Path json = EmptyTestFolder() / "rows.json";
  const ToolRun run =
      RunToolBinary("fathom_compare", {Log("lbv_surge"), "--sources=camera", Flag("json", json)});
  EXPECT_THAT(run.exit_code, AnyOf(0, 2)) << run.err;
  std::set<std::string> families;
  const auto comparison = JsonOf(json);
  for (const auto& row : comparison["rows"]) {
    families.insert(row["family"]);
    EXPECT_EQ(row["source"], "camera");
    EXPECT_NE(row["message"], "") << row["family"];
    EXPECT_EQ(row["usable"].get<bool>(), !row["heldout_nmae"].is_null()) << row["family"];
  }
  EXPECT_EQ(families, (std::set<std::string>{"least_squares", "adaptive", "output_error"}));
}

// Its command leads the rate by more than a quarter period: no passive vehicle does that.
TEST_F(RealLogsTool, LbvYawIsFoundNotToBePassive) {
  for (const char* tool : {"fathom_identify", "fathom_compare"}) {
    const ToolRun run = RunToolBinary(tool, {Log("lbv_yaw")});
    EXPECT_THAT(run.err, AllOf(HasSubstr("WARNING: "), HasSubstr("passive"))) << tool;
  }
}

// The command is a sum of currents: only ratios mean anything, and the tool says so.
TEST_F(RealLogsTool, PoolRovSurgeIsPredictedAndGivenAsRatios) {
  const ToolRun run = RunsWell("fathom_identify", {Log("pool_rov_surge"), "--dof=surge"});
  EXPECT_LE(NumberBehind("NMAE ", run.out, "held out"), 0.105);
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("linear_damping / inertia "),
                    HasSubstr("quadratic_damping / inertia "),
                    HasSubstr(" 1/s "),
                    HasSubstr(" 1/m "),
                    HasSubstr("The command is in A, not in N")));
  EXPECT_GT(NumberBehind("linear_damping / inertia", run.out), 0.0);
  EXPECT_GT(NumberBehind("quadratic_damping / inertia", run.out), 0.0);
}

struct SoundRun {
  std::string log;
  std::string dof;
};

// No tool warns of a sound log, nor of what a model of the log predicts of it.
TEST_F(RealLogsTool, WarnNoneOfSoundLogs) {
  const std::string model = (EmptyTestFolder() / "model.json").string();
  std::vector<SoundRun> runs = {{"lbv_surge", "surge"},
                                {"pool_rov_surge", "surge"},
                                {"emps_pulses_velocity", "surge"},
                                {"emps_pulses_pose", "surge"}};
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "kingfisher_runs")) {
    if (!std::filesystem::exists(entry.path() / "log.yaml")) continue;
    const std::string name = "kingfisher_runs/" + entry.path().filename().string();
    runs.push_back({name, "surge"});
    runs.push_back({name, "yaw"});
  }
  for (const SoundRun& sound : runs) {
    const ToolRun identified = RunToolBinary(
        "fathom_identify", {Log(sound.log), "--dof=" + sound.dof, "--model=" + model});
    EXPECT_THAT(identified.err, Not(HasSubstr("WARNING: "))) << sound.log << ", " << sound.dof;
    if (identified.exit_code != 0) continue;
    const ToolRun simulated =
        RunToolBinary("fathom_simulate", {"--model=" + model, Log(sound.log)});
    EXPECT_THAT(simulated.err, Not(HasSubstr("WARNING: "))) << sound.log << ", " << sound.dof;
  }
}

}  // namespace
}  // namespace fathom
