// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Which stretches of ordinary dives do instead of an experiment.

#include "expect_refusal.h"
#include "plan_inputs.h"
#include "saved_files.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Slow pushes over four minutes, and from 120 to 150 s a sprint each way: of FlatFish's surge.
std::string OrdinaryLog(const PlanInputs& inputs) {
  std::string command = "t,tau_surge\n";
  for (int t = 0; t < 240; t += 5) {
    const int push = t / 5 % 6;
    double force = push < 2 ? 20.0 : push < 4 ? -13.0 : 0.0;
    if (t >= 120 && t < 150) force = t < 135 ? 280.0 : -280.0;
    command += std::to_string(t) + "," + std::to_string(force) + "\n";
  }
  WriteTestFile(inputs.folder / "pushes.csv", command + "240,0\n");
  const std::string experiment =
      WriteTestFile(inputs.folder / "pushes.yaml",
                    "name: pushes\nduration: 240\ncommand_rate: 10\n"
                    "surge: {control: open_loop, input: {kind: file, file: pushes.csv}}\n"
                    "velocity: {rate: 10, noise: {surge: 0.01}}\n")
          .string();
  RunsWell("fathom_synthesize",
           {"--vehicle=" FATHOM_DATA_DIR "/vehicles/flatfish.yaml",
            "--experiment=" + experiment,
            "--out=" + inputs.At("log")});
  return inputs.At("log");
}

// The stretch that holds the sprint comes first; the command that it prints fits what was chosen,
// with the intervals that it foretold.
TEST(PlanTool, SaysWhichStretchesOfOrdinaryDivesDo) {
  const PlanInputs inputs;
  const std::string log = OrdinaryLog(inputs);
  const ToolRun run = RunsWell("fathom_plan",
                               {"--ordinary",
                                "--log=" + log,
                                "--dof=surge",
                                "--json=" + inputs.At("dives.json"),
                                "--report=" + inputs.At("dives.html")});
  EXPECT_THAT(run.out, HasSubstr("Of 4.0 min of surge, "));
  const auto dives = JsonOf(inputs.At("dives.json"));
  EXPECT_EQ(dives.at("schema"), "fathom-ordinary-1");
  nlohmann::json last;
  int num_chosen = 0;
  for (const auto& stretch : dives.at("stretches")) {
    if (stretch.at("choice").is_null()) continue;
    ++num_chosen;
    if (stretch.at("choice") == 1) {
      EXPECT_LT(stretch.at("from"), 135.0);
      EXPECT_GT(stretch.at("to"), 135.0);
    }
    if (last.is_null() || stretch.at("choice") > last.at("choice")) last = stretch;
  }
  EXPECT_LT(num_chosen, static_cast<int>(dives.at("stretches").size()));
  const std::string page = TextOf(inputs.At("dives.html"));
  EXPECT_THAT(page, HasSubstr("Which ordinary dives do: surge"));
  EXPECT_THAT(page, HasSubstr("Chosen stretches"));
  EXPECT_THAT(page, HasSubstr("1st choice"));

  std::vector<std::string> arguments =
      HintedArguments(run.out, "next, to fit the chosen stretches alone: fathom_identify ");
  ASSERT_FALSE(arguments.empty()) << run.out;
  arguments.push_back("--model=" + inputs.At("part.json"));
  RunsWell("fathom_identify", arguments);
  const auto fitted = JsonOf(inputs.At("part.json")).at("parameters");
  for (const auto& [name, std] : last.at("together").at("std").items()) {
    const double reported = fitted.at(name).at("std");
    EXPECT_NEAR(std.get<double>() / reported, 1.0, 0.2) << name;
  }

  // By another model, as the file says.
  const ToolRun by_model =
      RunsWell("fathom_plan", {"--ordinary", "--log=" + log, "--model=" + inputs.At("part.json")});
  EXPECT_THAT(by_model.out, HasSubstr("Of 4.0 min of surge, "));
}

TEST(PlanTool, RefusesFlagsThatDoNotGoWithOrdinaryDives) {
  const PlanInputs inputs;
  const std::string log = "--log=" + WriteSmallLog(inputs.folder / "small").string();
  const auto refusal = [&](const std::vector<std::string>& arguments) {
    return ExpectRefusal("fathom_plan", arguments, inputs.folder);
  };
  EXPECT_THAT(refusal({"--ordinary"}), HasSubstr("--log: is missing, expected the logs"));
  for (const std::string& flag : {"--out=" + inputs.At("plan"),
                                  "--limits=" + inputs.tank,
                                  "--verdict=" + inputs.model,
                                  "--vehicle=" + inputs.vehicle,
                                  std::string("--duration=60"),
                                  std::string("--voltage=16"),
                                  std::string("--seed=2")}) {
    EXPECT_THAT(refusal({"--ordinary", log, flag}),
                AllOf(HasSubstr(flag.substr(0, flag.find('=')) + ": goes with"),
                      HasSubstr("expected none with --ordinary")));
  }
  EXPECT_THAT(inputs.Refusal({"--json=" + inputs.At("dives.json")}),
              HasSubstr("--json: goes with --ordinary"));
  EXPECT_THAT(refusal({"--ordinary", log, "--held_out=0:100"}),
              HasSubstr("--held_out: takes all of the data"));
}

}  // namespace
}  // namespace fathom
