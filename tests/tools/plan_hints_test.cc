// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The next experiment after what other tools said of a log.

#include <cmath>

#include "expect_refusal.h"
#include "plan_inputs.h"
#include "saved_files.h"
#include "small_log.h"
#include <Eigen/LU>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A sine alone, which tells little, of FlatFish's surge.
std::string SineLog(const PlanInputs& inputs, int amplitude, const std::string& effects = "") {
  const std::string experiment =
      WriteTestFile(inputs.folder / "sine.yaml",
                    "name: sine\nduration: 60\ncommand_rate: 10\n"
                    "surge: {control: open_loop, input: {kind: sine, frequency: 0.3, amplitude: " +
                        std::to_string(amplitude) +
                        "}}\nvelocity: {rate: 10, noise: {surge: 0.005}}\n")
          .string();
  std::vector<std::string> arguments = {"--vehicle=" FATHOM_DATA_DIR "/vehicles/flatfish.yaml",
                                        "--experiment=" + experiment,
                                        "--seed=" + std::to_string(amplitude),
                                        "--out=" + inputs.At("log")};
  if (!effects.empty()) arguments.push_back("--effects=" + effects);
  RunsWell("fathom_synthesize", arguments);
  return inputs.At("log");
}

// What fathom_diagnose prints is typed, and the plan tells the causes apart that it left open.
TEST(PlanTool, PlansTheDecidingRunAsFathomDiagnoseSays) {
  const PlanInputs inputs;
  const std::string log = SineLog(inputs, 53, "thrust_dead_zone:width=8");
  const std::string beginning = "next, to plan the deciding run: fathom_plan ";
  const std::vector<std::string> diagnose = {"--log=" + log, "--dof=surge"};
  const ToolRun without_file = RunsWell("fathom_diagnose", diagnose);
  ASSERT_THAT(without_file.out, HasSubstr("surge: ambiguous"));
  EXPECT_THAT(without_file.out, Not(HasSubstr("fathom_plan")));

  const std::string verdict = "--verdict=" + inputs.At("verdict.json");
  const ToolRun run = RunsWell("fathom_diagnose", {diagnose[0], diagnose[1], verdict});
  std::vector<std::string> hinted = HintedArguments(run.out, beginning);
  ASSERT_EQ(hinted, (std::vector<std::string>{verdict, "--duration=60", "--out=plan"}));
  hinted.back() = "--out=" + inputs.At("plan");
  EXPECT_THAT(RunsWell("fathom_plan", hinted).out, HasSubstr("No limits file was given"));
  const auto plan = JsonOf(inputs.At("plan/plan.json"));
  ASSERT_FALSE(plan.at("separations").empty());
  for (const auto& pair : plan.at("separations")) EXPECT_GT(pair.at("sigmas"), 5.0) << pair;
  for (const double force : ReadColumns(inputs.At("plan/command.csv")).Values("tau_surge")) {
    EXPECT_LE(std::abs(force), 53.0);  // of the log
  }
}

// Both commands that fathom_check prints, one after the other.
TEST(PlanTool, PlansWhatALogLacksAsFathomCheckSays) {
  const PlanInputs inputs;
  const std::string log = SineLog(inputs, 30);
  const ToolRun check = RunToolBinary("fathom_check", {"--log=" + log});
  ASSERT_THAT(check.out, HasSubstr("leaves quadratic_damping unknown"));
  EXPECT_THAT(
      check.out,
      HasSubstr("\nnext: fathom_identify --log=" + log + " --dof=surge --model=surge.json\n"));
  std::vector<std::string> hinted =
      HintedArguments(check.out, "then, to plan the run that tells most of the rest: fathom_plan ");
  ASSERT_EQ(hinted,
            (std::vector<std::string>{"--model=surge.json", "--duration=60", "--out=plan"}));
  const std::string model = "--model=" + inputs.At("surge.json");
  RunsWell("fathom_identify", {"--log=" + log, "--dof=surge", model});
  RunsWell("fathom_plan", {model, hinted[1], "--out=" + inputs.At("plan")});
  const auto damping = JsonOf(inputs.At("plan/plan.json")).at("parameters").at("quadratic_damping");
  EXPECT_LT(damping.at("std_with_log_so_far"), damping.at("std_before"));
}

// The information of a model file.
Eigen::Matrix4d InformationIn(const std::string& model) {
  const auto rows = JsonOf(model).at("covariance");
  Eigen::Matrix4d covariance;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) covariance(i, k) = rows.at(i).at(k);
  }
  return covariance.inverse();
}

// A second log counts as much as its own fit tells; the model's own log does not count again.
TEST(PlanTool, CountsWhatWasFlownSince) {
  const PlanInputs inputs;
  std::filesystem::rename(SineLog(inputs, 50), inputs.folder / "first");
  std::filesystem::rename(SineLog(inputs, 53), inputs.folder / "second");
  const std::vector<std::string> logs = {"--log=" + inputs.At("first"),
                                         "--log=" + inputs.At("second")};
  const std::string model = "--model=" + inputs.At("one.json");
  RunsWell("fathom_identify", {logs[0], "--dof=surge", model});
  RunsWell("fathom_identify", {logs[1], "--dof=surge", "--model=" + inputs.At("other.json")});
  const std::vector<std::string> plan = {model, "--duration=20", "--out=" + inputs.At("plan")};
  const ToolRun run = RunsWell("fathom_plan", {plan[0], plan[1], plan[2], logs[1]});
  EXPECT_THAT(run.out, HasSubstr("note: What the logs of --log tell counts before, after"));
  const auto planned = JsonOf(inputs.At("plan/plan.json")).at("parameters");
  const Eigen::Matrix4d both =
      (InformationIn(inputs.At("one.json")) + InformationIn(inputs.At("other.json"))).inverse();
  const std::vector<std::string> names = {
      "inertia", "quadratic_damping", "linear_damping", "buoyancy"};
  for (int i = 0; i < 4; ++i) {
    // 600 samples tell their noise to 3 %, the noise's correlations to as much again.
    const double before = planned.at(names[i]).at("std_before");
    EXPECT_NEAR(before / std::sqrt(both(i, i)), 1.0, 0.3) << names[i];
  }
  EXPECT_THAT(ExpectRefusal("fathom_plan", {model, plan[1], logs[0]}, inputs.folder),
              HasSubstr("--log: " + inputs.At("first") + " is a log that " + inputs.At("one.json") +
                        " was fitted to"));
  EXPECT_THAT(ExpectRefusal("fathom_plan", {model, plan[1], logs[1], "--dof=yaw"}, inputs.folder),
              HasSubstr("--dof: is yaw, expected surge"));
  EXPECT_THAT(
      ExpectRefusal("fathom_plan", {model, plan[1], logs[1], "--held_out=1:2"}, inputs.folder),
      HasSubstr("--held_out: all of a log counts"));
}

// A model of currents of motors has no forces to plan, a log that tells all needs no plan.
TEST(PlanTool, IsNotNamedWhereItWouldRefuseOrNothingIsOpen) {
  const PlanInputs inputs;
  const std::string log = SineLog(inputs, 30);
  WriteTestFile(inputs.folder / "log/log.yaml", "name: log\ndof: surge\ncommand_unit: A\n");
  const ToolRun in_ampere = RunToolBinary("fathom_check", {"--log=" + log});
  ASSERT_THAT(in_ampere.out, HasSubstr("leaves quadratic_damping unknown"));
  EXPECT_THAT(in_ampere.out, Not(HasSubstr("fathom_plan")));
  const ToolRun known =
      RunToolBinary("fathom_check", {"--log=" + WriteSmallLog(inputs.folder / "small").string()});
  ASSERT_THAT(known.out, HasSubstr("next: fathom_identify"));
  EXPECT_THAT(known.out, Not(HasSubstr("fathom_plan")));
}

}  // namespace
}  // namespace fathom
