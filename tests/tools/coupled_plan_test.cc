// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The next experiment of a model of several DOFs.

#include <algorithm>
#include <cmath>

#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using Path = std::filesystem::path;

// A model of surge, sway and yaw, and the lake it is driven in.
struct CoupledInputFiles {
  Path folder = EmptyTestFolder();
  std::string model = At("boat.json");
  std::string lake =
      WriteTestFile(folder / "lake.yaml",
                    "force: {surge: 40, sway: 40, yaw: 8}\nspeed: {surge: 0.8, sway: 0.6}\n"
                    "distance: {back: 8, ahead: 8, port: 8, starboard: 8}\n")
          .string();
  std::string vehicle = "--vehicle=" FATHOM_DATA_DIR "/vehicles/planar_rov.yaml";

  CoupledInputFiles() {
    const std::string first =
        WriteTestFile(folder / "first.yaml",
                      "name: first\nduration: 60\ncommand_rate: 10\n"
                      "surge: {control: open_loop, input: {kind: prbs, amplitude: 20, hold: 2}}\n"
                      "sway: {control: open_loop, input: {kind: prbs, amplitude: 20, hold: 3}}\n"
                      "yaw: {control: open_loop, input: {kind: prbs, amplitude: 4, hold: 1}}\n"
                      "velocity: {rate: 10, noise: {surge: 0.01, sway: 0.01, yaw: 0.01}}\n")
            .string();
    RunsWell("fathom_synthesize", {vehicle, "--experiment=" + first, "--out=" + At("first")});
    Identify("first", model);
  }

  std::string At(const std::string& name) const { return (folder / name).string(); }

  // A verdict on that model, which names an entry that may also be one of two others.
  std::string Verdict(const std::string& verdict) const {
    const std::string text = R"({"schema": "fathom-verdict-2", "verdict": ")" + verdict +
                             R"(", "causes": [{"entry": "inertia.sway.yaw", "alternatives": )"
                             R"(["linear_damping.sway.yaw", "thrust_gain.port"]}], "model": )" +
                             TextOf(model) + "}";
    return WriteTestFile(folder / (verdict + ".json"), text).string();
  }

  void Identify(const std::string& log, const std::string& to) const {
    RunsWell("fathom_identify",
             {"--log=" + At(log),
              "--dofs=surge,sway,yaw",
              "--structure=coriolis",
              "--free=inertia.sway.yaw",
              "--model=" + to});
  }

  ToolRun Plan(const std::vector<std::string>& more = {}) const {
    return RunToolBinary("fathom_plan", Arguments(more));
  }
  std::string Refusal(const std::vector<std::string>& more) const {
    return ExpectRefusal("fathom_plan", Arguments(more), folder);
  }

  std::vector<std::string> Arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"--model=" + model, "--limits=" + lake};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

// From a log to the next one, on several axes.
TEST(PlanTool, PlansAWrenchForACoupledModel) {
  const CoupledInputFiles inputs;
  const ToolRun run = RunsWell(inputs.Plan(
      {"--duration=30", "--out=" + inputs.At("plan"), "--report=" + inputs.At("plan.html")}));
  EXPECT_THAT(run.out, HasSubstr("Command surge, sway, yaw for 30 s as planned."));
  EXPECT_THAT(run.out, HasSubstr("inertia.sway.yaw [kg m]"));
  const CsvColumns command = ReadColumns(inputs.At("plan/command.csv"));
  EXPECT_EQ(command.names, (std::vector<std::string>{"t", "tau_surge", "tau_sway", "tau_yaw"}));
  ASSERT_EQ(command.rows.size(), 31U);
  EXPECT_EQ(command.rows.back(), (std::vector<double>{30.0, 0.0, 0.0, 0.0}));
  EXPECT_THAT(TextOf(inputs.At("plan.html")), HasSubstr("yaw command"));

  RunsWell("fathom_synthesize",
           {inputs.vehicle,
            "--experiment=" + inputs.At("plan/experiment.yaml"),
            "--out=" + inputs.At("next")});
  inputs.Identify("next", inputs.At("next.json"));
  const auto plan = JsonOf(inputs.At("plan/plan.json"));
  const auto next = JsonOf(inputs.At("next.json"));
  EXPECT_EQ(plan.at("schema"), "fathom-plan-2");
  EXPECT_EQ(plan.at("velocity").at("noise_source").at("yaw"), "log");
  std::vector<double> ratios;
  for (const auto& [name, entry] : plan.at("parameters").items()) {
    ratios.push_back(next.at("parameters").at(name).at("std").get<double>() /
                     entry.at("std_after").get<double>());
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_NEAR(ratios[ratios.size() / 2], 1.0, 0.25);
}

// Of another dive of the same boat. `std_before` is what is known before the plan.
TEST(PlanTool, CountsAnotherDiveOfACoupledModel) {
  const CoupledInputFiles inputs;
  RunsWell("fathom_synthesize",
           {inputs.vehicle,
            "--experiment=" + inputs.At("first.yaml"),
            "--seed=2",
            "--out=" + inputs.At("second")});
  RunsWell(inputs.Plan({"--duration=10", "--out=" + inputs.At("alone")}));
  const ToolRun run = RunsWell(
      inputs.Plan({"--duration=10", "--log=" + inputs.At("second"), "--out=" + inputs.At("plan")}));
  EXPECT_THAT(run.out, HasSubstr("note: What the logs of --log tell counts before, after, "));
  const auto alone = JsonOf(inputs.At("alone/plan.json")).at("parameters");
  const auto with_log = JsonOf(inputs.At("plan/plan.json")).at("parameters");
  // As much again as the log that the model was fitted to.
  std::vector<double> ratios;
  for (const auto& [name, entry] : with_log.items()) {
    ratios.push_back(entry.at("std_before").get<double>() /
                     alone.at(name).at("std_before").get<double>());
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_NEAR(ratios[ratios.size() / 2], std::sqrt(0.5), 0.1);
}

// The boat with the thrusters of a BlueROV2: what they push by arithmetic of the test.
TEST(PlanTool, WritesWhatTheThrustersDoUnderAWrench) {
  const CoupledInputFiles inputs;
  const std::string heavy = "--vehicle=" FATHOM_DATA_DIR "/vehicles/bluerov2_heavy.yaml";
  WriteTestFile(inputs.lake,
                "force: {surge: 40, sway: 40, yaw: 8}\nspeed: {surge: 0.8, sway: 0.6}\n"
                "thruster_force: 20\n");
  const ToolRun run =
      RunsWell(inputs.Plan({"--duration=20", "--voltage=16", heavy, "--out=" + inputs.At("plan")}));
  EXPECT_THAT(run.out, HasSubstr("note: The plan takes at most "));
  const CsvColumns wrench = ReadColumns(inputs.At("plan/command.csv"));
  const CsvColumns thrusts = ReadColumns(inputs.At("plan/thrusters.csv"));
  ASSERT_EQ(thrusts.rows.size(), wrench.rows.size());
  ASSERT_EQ(thrusts.names.size(), 9U);
  for (std::size_t i = 0; i < thrusts.rows.size(); ++i) {
    const std::vector<double>& t = thrusts.rows[i];
    EXPECT_EQ(t[0], wrench.rows[i][0]);
    for (std::size_t k = 1; k < t.size(); ++k) EXPECT_LE(std::abs(t[k]), 20.0);
    const double level = std::sqrt(0.5);
    EXPECT_NEAR(level * (-t[1] - t[2] + t[3] + t[4]), wrench.rows[i][1], 1e-4);
    EXPECT_NEAR(level * (t[1] - t[2] + t[3] - t[4]), wrench.rows[i][2], 1e-4);
    // Arms of 0.156 m and 0.111 m: each of the four turns by their sum.
    EXPECT_NEAR(level * 0.267 * (t[1] - t[2] - t[3] + t[4]), wrench.rows[i][3], 1e-4);
    EXPECT_NEAR(t[5] + t[6] + t[7] + t[8], 0.0, 1e-4);
  }
  EXPECT_EQ(ReadColumns(inputs.At("plan/pulses.csv")).rows.back()[1], 1500.0);
  EXPECT_THAT(TextOf(inputs.At("plan/plan.lua")),
              HasSubstr("-- Planned by fathom_plan: surge, sway, yaw for 20 s, at 16 V."));
  const auto thruster = JsonOf(inputs.At("plan/plan.json")).at("thrusters").at(0);
  EXPECT_EQ(thruster.at("name"), "front_starboard");
  EXPECT_NEAR(thruster.at("share").at("surge"), -std::sqrt(0.125), 1e-6);
  EXPECT_EQ(thruster.at("range"), (std::vector<double>{-20.0, 20.0}));
  EXPECT_THAT(inputs.Refusal({"--duration=20"}),
              HasSubstr(inputs.lake + ": key 'thruster_force' goes with --vehicle"));
}

// A verdict by hand: of the coupling that the model holds, left open against others.
TEST(PlanTool, PlansAWrenchThatTellsTheCausesOfACoupledVerdictApart) {
  const CoupledInputFiles inputs;
  const ToolRun run = RunsWell(RunToolBinary("fathom_plan",
                                             {"--verdict=" + inputs.Verdict("ambiguous"),
                                              "--limits=" + inputs.lake,
                                              "--duration=30",
                                              "--out=" + inputs.At("plan"),
                                              "--report=" + inputs.At("plan.html")}));
  const std::string pair = "inertia.sway.yaw against linear_damping.sway.yaw: decided at ";
  EXPECT_THAT(run.out, HasSubstr(pair));
  EXPECT_THAT(run.out, HasSubstr("How far a wrong cause will miss, in standard deviations"));
  EXPECT_THAT(run.err,
              HasSubstr("fathom_plan: inertia.sway.yaw against thrust_gain.port is left out: a "
                        "wrench tells nothing of single thrusters and fins."));
  EXPECT_THAT(TextOf(inputs.At("plan.html")), HasSubstr(pair));
  const auto separations = JsonOf(inputs.At("plan/plan.json")).at("separations");
  ASSERT_EQ(separations.size(), 2U);
  EXPECT_EQ(separations.at(0).at("truth"), "inertia.sway.yaw");
  EXPECT_EQ(separations.at(0).at("assumed"), "linear_damping.sway.yaw");
  EXPECT_GT(separations.at(0).at("sigmas"), separations.at(0).at("sigmas_of_sine"));
}

TEST(PlanTool, TakesAVerdictOfOneCauseForItsModel) {
  const CoupledInputFiles inputs;
  const ToolRun model = RunsWell(RunToolBinary(
      "fathom_plan",
      {"--verdict=" + inputs.Verdict("explained"), "--limits=" + inputs.lake, "--duration=15"}));
  EXPECT_EQ(model.out, RunsWell(inputs.Plan({"--duration=15"})).out);
}

TEST(PlanTool, RefusesWhatACoupledModelIsNotPlannedWith) {
  const CoupledInputFiles inputs;
  const auto refused = [&](const std::vector<std::string>& flags, const std::string& why) {
    EXPECT_THAT(inputs.Refusal(flags), HasSubstr(why));
  };
  refused({"--duration=30", inputs.vehicle}, "planar_rov.yaml: has no thrusters, expected some");
  refused({"--duration=30", "--voltage=16"}, "--voltage: goes with --vehicle");
  refused({"--duration=30", "--log=" + inputs.At("first")}, " was fitted to, and counts by the ");
  refused({"--duration=30", "--velocity=v.csv"}, "--velocity: goes with a model of one DOF");
  refused({"--duration=30", "--correct=r:-1"}, "--correct: goes with --log");
  refused({"--duration=1"}, "--duration: is 1 s, expected 5 to 3600 s.");
  refused({}, "--duration: is missing, expected seconds, or `minutes` in ");
  refused({"--duration=30", "--dofs=surge,heave"}, "--dofs: names heave, which ");
  EXPECT_THAT(ExpectRefusal("fathom_plan", {"--model=" + inputs.model, "--duration=30"}),
              HasSubstr("--limits: is missing, expected a limits file"));
  WriteTestFile(inputs.lake, "force: {surge: 40}\ndistance: {back: 0.001, ahead: 0.001}\n");
  const ToolRun none = inputs.Plan({"--duration=30"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("No command was found that keeps the limits"));
}

}  // namespace
}  // namespace fathom
