// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include "expect_refusal.h"
#include "plan_inputs.h"
#include "saved_files.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

TEST(PlanTool, WritesACommandWithinItsLimits) {
  const PlanInputs inputs;
  const ToolRun run = RunsWell(inputs.Plan({"--report=" + inputs.At("plan.html")}));
  EXPECT_THAT(run.out, HasSubstr("Command surge for 42 s as planned."));
  EXPECT_THAT(run.out, HasSubstr("inertia [kg]"));

  // A force for each hold of 0.7 s, and the end.
  const CsvColumns command = ReadColumns(inputs.At("plan/command.csv"));
  ASSERT_EQ(command.rows.size(), 61U);
  EXPECT_EQ(command.rows.back(), (std::vector<double>{42.0, 0.0}));
  for (const double force : command.Values("tau_surge")) EXPECT_LE(std::abs(force), 12.0);

  const auto plan = JsonOf(inputs.At("plan/plan.json"));
  EXPECT_EQ(plan.at("schema"), "fathom-plan-1");
  EXPECT_GE(plan.at("distance_range").at(0), -2.0);
  EXPECT_LE(plan.at("distance_range").at(1), 3.0);
  EXPECT_LE(plan.at("share_breaking"), 0.01);
  EXPECT_NEAR(plan.at("parameters").at("inertia").at("std_before"), 0.4, 1e-9);
  EXPECT_THAT(TextOf(inputs.At("plan.html")), HasSubstr("The next experiment: surge"));
}

// What is played is what was planned, and is then known as well as was said.
TEST(PlanTool, WritesAnExperimentThatFathomSynthesizePlays) {
  const PlanInputs inputs;
  RunsWell(inputs.Plan());
  RunsWell("fathom_synthesize",
           {"--vehicle=" + inputs.vehicle,
            "--experiment=" + inputs.At("plan/experiment.yaml"),
            "--out=" + inputs.At("log")});
  const CsvColumns planned = ReadColumns(inputs.At("plan/command.csv"));
  const CsvColumns logged = ReadColumns(inputs.At("log/command.csv"));
  ASSERT_EQ(logged.rows.size(), 7U * 60U);
  for (std::size_t i = 0; i < logged.rows.size(); ++i) {
    EXPECT_EQ(logged.rows[i][1], planned.rows[i / 7][1]) << "row " << i;
  }
  RunsWell("fathom_identify",
           {"--log=" + inputs.At("log"), "--dof=surge", "--model=" + inputs.At("next.json")});
  const auto plan = JsonOf(inputs.At("plan/plan.json"));
  const auto next = JsonOf(inputs.At("next.json"));
  for (const char* parameter : {"inertia", "quadratic_damping", "linear_damping", "buoyancy"}) {
    const double std = next.at("parameters").at(parameter).at("std");
    const double forecast = plan.at("parameters").at(parameter).at("std_after");
    // 420 samples tell their noise to 3.5 %, the noise's correlations to as much again.
    EXPECT_NEAR(std / forecast, 1.0, 0.3) << parameter;
  }
}

// Pulses of another plan must not be played beside this command.
TEST(PlanTool, LeavesNoThrustersOfAFormerPlan) {
  const PlanInputs inputs;
  const auto formers = {"plan/thrusters.csv", "plan/pulses.csv", "plan/plan.lua"};
  RunsWell(inputs.Plan());
  for (const char* former : formers) WriteTestFile(inputs.At(former), "of a former plan");
  WriteTestFile(inputs.At("plan/mine.txt"), "of the user");
  RunsWell(inputs.Plan());
  for (const char* former : formers) EXPECT_FALSE(std::filesystem::exists(inputs.At(former)));
  EXPECT_TRUE(std::filesystem::exists(inputs.At("plan/mine.txt")));
}

TEST(PlanTool, ReplacesNothingThatIsOfNoPlan) {
  const PlanInputs inputs;
  std::filesystem::create_directory(inputs.At("plan"));
  WriteTestFile(inputs.At("plan/command.csv"), "t,tau_surge\n0,1\n");
  EXPECT_THAT(inputs.Refusal(), HasSubstr("holds command.csv, which is of no plan"));
  EXPECT_EQ(TextOf(inputs.At("plan/command.csv")), "t,tau_surge\n0,1\n");
}

// Of 20 kN nothing is of use in this tank: a twentieth passes the limits within one hold.
TEST(PlanTool, PlansWithTheForceThatItsLimitsLeave) {
  const PlanInputs inputs;
  WriteTestFile(inputs.tank,
                "force: 20000\nspeed: 0.5\ndistance: {back: 2, ahead: 3}\nshortest_hold: 0.7\n");
  const ToolRun run = RunsWell(inputs.Plan());
  EXPECT_THAT(run.out, HasSubstr(" N is of no use"));
  const auto plan = JsonOf(inputs.At("plan/plan.json"));
  EXPECT_GT(plan.at("speed_range").at(1), 0.1);
  EXPECT_LT(plan.at("parameters").at("inertia").at("std_after"), 1.0);
}

TEST(PlanTool, GivesTheSamePlanForTheSameSeed) {
  const PlanInputs inputs;
  RunsWell(inputs.Plan());
  const std::string first = TextOf(inputs.At("plan/plan.json"));
  RunsWell(inputs.Plan());
  EXPECT_EQ(TextOf(inputs.At("plan/plan.json")), first);
}

TEST(PlanTool, SaysWhereNoCommandKeepsTheLimits) {
  const PlanInputs inputs;
  WriteTestFile(inputs.tank, "force: 12\ndistance: {back: 0.001, ahead: 0.001}\n");
  const ToolRun run = inputs.Plan();
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("No command was found that keeps the limits"));
  EXPECT_FALSE(std::filesystem::exists(inputs.At("plan")));
}

TEST(PlanTool, RefusesWhatItCannotUse) {
  const PlanInputs inputs;
  const auto refusal = [&](const std::vector<std::string>& arguments) {
    return ExpectRefusal("fathom_plan", arguments, inputs.folder);
  };
  const std::string model = "--model=" + inputs.model, limits = "--limits=" + inputs.tank;
  EXPECT_THAT(refusal({limits}), HasSubstr("--model: is missing, expected either"));
  EXPECT_THAT(refusal({model, "--verdict=" + inputs.model, limits}), HasSubstr("beside --verdict"));
  EXPECT_THAT(refusal({model}),
              HasSubstr("--limits: is missing, expected a limits file, since " + inputs.model));
  EXPECT_THAT(refusal({model, limits}), HasSubstr("or `minutes` in " + inputs.tank));
  EXPECT_THAT(refusal({model, limits, "--duration=2"}), HasSubstr("--duration: is 2 s"));
  WriteTestFile(inputs.tank, "force: 12\nshortest_hold: 40\n");
  EXPECT_THAT(refusal({model, limits, "--duration=30"}),
              HasSubstr("`shortest_hold` of " + inputs.tank));
  WriteTestFile(inputs.tank, "force: 12\ndistance: {back: -1}\n");
  EXPECT_THAT(refusal({model, limits, "--duration=60"}),
              HasSubstr(inputs.tank + ":2: key 'distance.back' is "));
}

}  // namespace
}  // namespace fathom
