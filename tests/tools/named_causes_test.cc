// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Which causes fathom_diagnose names, and how.

#include <filesystem>
#include <string>

#include "run_tool.h"
#include "saved_files.h"
#include "synthesized_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Path = std::filesystem::path;

struct DiagnosedLog {
  explicit DiagnosedLog(const Path& folder, const Path& log) {
    const Path verdict = folder / "verdict.json", report = folder / "page.html";
    run = RunToolBinary("fathom_diagnose",
                        {Flag("log", log), Flag("verdict", verdict), Flag("report", report)});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    json = JsonOf(verdict);
    header = HeaderOf(TextOf(report));
  }
  ToolRun run;
  nlohmann::json json;
  std::string header;  // of the page
};

// The dead zone is certain in the training data, and a model that has it predicts the rest worse.
TEST(NamedCauses, AreNoneWhereUnseenDataGetWorse) {
  const Path folder = EmptyTestFolder();
  const DiagnosedLog diagnosed(folder, SmallLogThatLoses(folder, "thrust_dead_zone:width=6", 1));
  EXPECT_THAT(diagnosed.run.out, StartsWith("surge: unexplained\n"));
  EXPECT_EQ(diagnosed.json["causes"], nlohmann::json::array());
  EXPECT_THAT(diagnosed.json["sentence"].get<std::string>(),
              ContainsRegex("fits best with thrust_dead_zone, but the error on held-out data grows "
                            "by .*: no cause is named"));
}

// A smaller one, of which too little is held out: a loss of 1 % that may be a gain of 69 %.
TEST(NamedCauses, MayBeThereWhereUnseenDataDoNotDecide) {
  const Path folder = EmptyTestFolder();
  const DiagnosedLog diagnosed(folder, SmallLogThatLoses(folder, "thrust_dead_zone:width=3", 1));
  EXPECT_THAT(diagnosed.json["sentence"].get<std::string>(),
              HasSubstr("may come from a thruster dead zone"));
  EXPECT_THAT(diagnosed.run.out,
              HasSubstr("The held-out data do not confirm this cause: use the model without it"));
}

// Under two minutes of one slow tone, thrust that fades looks like six other effects.
TEST(NamedCauses, AreToldByTheirPlaceWhereManyFitAsWell) {
  const Path folder = EmptyTestFolder();
  const Path experiment = WriteTestFile(
      folder / "slow.yaml",
      "name: slow\n"
      "duration: 120\n"
      "command_rate: 10\n"
      "surge: {control: open_loop, input: {kind: sine, amplitude: 15, frequency: 0.05}}\n"
      "velocity: {rate: 10, noise: {surge: 0.02}}\n"
      "held_out: [90, 120]\n");
  const Path log = Synthesized(WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml()),
                               experiment,
                               "thrust_fade:rate=0.002",
                               1,
                               folder / "log");
  const DiagnosedLog diagnosed(folder, log);
  ASSERT_EQ(diagnosed.json["causes"].size(), 1u) << diagnosed.run.out;
  ASSERT_GT(diagnosed.json["causes"][0]["alternatives"].size(), 4u);
  EXPECT_THAT(
      diagnosed.json["sentence"].get<std::string>(),
      HasSubstr(" comes from an effect of the actuator or in the water or of the sensor: "));
  for (const std::string& text : {diagnosed.run.out, diagnosed.header}) {
    EXPECT_THAT(text, Not(ContainsRegex("one of [0-9a-z]+ others")));
  }
}

// A step of 16 N where the thrust is 12 N rms.
TEST(NamedCauses, AreNoPayloadWhereAStepIsAsLargeAsTheThrust) {
  const Path folder = EmptyTestFolder();
  const DiagnosedLog diagnosed(folder,
                               SmallLogWith(folder, "log", "buoyancy_step:jump=16:time=30", 1));
  EXPECT_EQ(diagnosed.json["causes"][0]["effect"], "buoyancy_step");
  EXPECT_THAT(diagnosed.run.out, HasSubstr("The step is as large as the thrust itself."));
  EXPECT_THAT(diagnosed.run.out, Not(HasSubstr("Look for a payload dropped")));
}

}  // namespace
}  // namespace fathom
