// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/process/run_child.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <Eigen/LU>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

const char* const kTank =
    "force: 12\nspeed: 0.5\ndistance: {back: 2, ahead: 3}\nshortest_hold: 0.7\n";

// In an empty folder: the small model, a tank, and what is to be written.
struct PlanInputs {
  Path folder = EmptyTestFolder();
  std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  std::string tank = WriteTestFile(folder / "tank.yaml", kTank).string();
  std::string vehicle = WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml()).string();

  std::string At(const std::string& name) const { return (folder / name).string(); }

  ToolRun Plan(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {
        "--model=" + model, "--limits=" + tank, "--duration=42", "--out=" + At("plan")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunToolBinary("fathom_plan", arguments);
  }
};

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
  EXPECT_LE(plan.at("share_breaking"), 0.05);
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
  std::filesystem::create_directory(inputs.At("plan"));
  for (const char* former : formers) WriteTestFile(inputs.At(former), "of a former plan");
  WriteTestFile(inputs.At("plan/mine.txt"), "of the user");
  RunsWell(inputs.Plan());
  for (const char* former : formers) EXPECT_FALSE(std::filesystem::exists(inputs.At(former)));
  EXPECT_TRUE(std::filesystem::exists(inputs.At("plan/mine.txt")));
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

// The vehicle of the small model, with the thrusters of a BlueROV2.
struct ThrusterInputs : PlanInputs {
  const std::string heavy = "--vehicle=" FATHOM_DATA_DIR "/vehicles/bluerov2_heavy.yaml";

  // Of a file in plan/.
  std::vector<double> Column(const std::string& file, const std::string& name) const {
    return ReadColumns(At("plan/" + file)).Values(name);
  }
};

// Thrusts give the wrench, pulse widths the thrusts, both by arithmetic of the test.
TEST(PlanTool, WritesWhatTheThrustersDo) {
  const ThrusterInputs inputs;
  const ToolRun run = RunsWell(inputs.Plan({inputs.heavy, "--voltage=16"}));
  EXPECT_THAT(run.out, HasSubstr("note: The plan takes at most "));
  EXPECT_THAT(run.out, HasSubstr(" % of what a thruster gives (`front_"));
  const std::vector<double> force = inputs.Column("command.csv", "tau_surge");
  ASSERT_EQ(inputs.Column("thrusters.csv", "t"), inputs.Column("command.csv", "t"));
  ASSERT_EQ(inputs.Column("pulses.csv", "t"), inputs.Column("command.csv", "t"));
  std::vector<double> along(force.size()), squares(force.size());
  for (int k = 1; k <= 4; ++k) {
    const std::vector<double> thrust =
        inputs.Column("thrusters.csv", "thruster_" + std::to_string(k));
    for (std::size_t i = 0; i < force.size(); ++i) {
      along[i] += (k <= 2 ? -1.0 : 1.0) * std::sqrt(0.5) * thrust[i];
      squares[i] += thrust[i] * thrust[i];
      EXPECT_LE(thrust[i], 51.5);
      EXPECT_GE(thrust[i], -39.9);
    }
  }
  for (std::size_t i = 0; i < force.size(); ++i) {
    EXPECT_NEAR(along[i], force[i], 1e-4);
    EXPECT_NEAR(squares[i], 0.5 * force[i] * force[i], 1e-3);  // as short as can be: all alike
  }
  // 16 V, from the table: 3.9 N at 1580 us and 1.5 N at 1552 us, 6.4 N back at 1380 us and 3.1 N at
  // 1420 us, still at 1500 us.
  const std::vector<double> thrust = inputs.Column("thrusters.csv", "thruster_3");
  const std::vector<double> pulse = inputs.Column("pulses.csv", "thruster_3");
  int num_compared = 0;
  for (std::size_t i = 0; i < thrust.size(); ++i) {
    double expected = -1.0;
    if (thrust[i] == 0.0) expected = 1500.0;
    if (thrust[i] >= 1.5 && thrust[i] <= 3.9) expected = 1552.0 + 28.0 * (thrust[i] - 1.5) / 2.4;
    if (thrust[i] <= -3.1 && thrust[i] >= -6.4) expected = 1420.0 + 40.0 * (thrust[i] + 3.1) / 3.3;
    if (expected < 0.0) continue;
    EXPECT_NEAR(pulse[i], expected, 0.5 + 1e-6) << thrust[i];
    ++num_compared;
  }
  EXPECT_GT(num_compared, 5);
  EXPECT_EQ(pulse.back(), 1500.0);
}

// Stands in for ArduSub: a clock, outputs, settings, a button and arming. Prints "t channel pulse
// timeout" for each output that a script sets, in ms and us, and what it says behind a "#".
// Arguments: the script, then at which ms what happens: press, arm, disarm; "no_motor" and
// "no_direction" leave motor 2 without.
constexpr const char* kStandIn = R"lua(
local now, armed, presses, motor_2, direction_2 = 0, false, 0, true, true
local events = {}
for i = 2, #arg do
  local at, what = arg[i]:match("^(%d+):(.+)$")
  if at then events[#events + 1] = {tonumber(at), what} end
  if arg[i] == "no_motor" then motor_2 = false end
  if arg[i] == "no_direction" then direction_2 = false end
end
local Uint32 = {}
Uint32.__index = Uint32
Uint32.__sub = function(a, b) return setmetatable({value = a.value - b.value}, Uint32) end
function Uint32:toint() return self.value end
function millis() return setmetatable({value = now}, Uint32) end
gcs, arming, sub, param, SRV_Channels = {}, {}, {}, {}, {}
function gcs:send_text(severity, text)
  assert(math.type(severity) == "integer" and #text <= 50, text)
  print("# " .. text)
end
function arming:is_armed() return armed end
function sub:get_and_clear_button_count(index)
  assert(index == 1)
  local count = presses
  presses = 0
  return count
end
function param:get(name)
  local motor = tonumber(name:match("^MOT_(%d+)_DIRECTION$"))
  if motor == 2 and not direction_2 then return nil end
  return motor == 3 and -1.0 or 1.0
end
function SRV_Channels:find_channel(fn)
  if fn == 34 and not motor_2 then return nil end
  return fn - 33 + 2
end
function SRV_Channels:set_output_pwm_chan_timeout(channel, pulse, timeout)
  for _, number in ipairs({channel, pulse, timeout}) do
    assert(math.type(number) == "integer" and number >= 0 and number <= 65535)
  end
  print(now, channel, pulse, timeout)
end
local update, wait = dofile(arg[1])
while update ~= nil and now < 60000 do
  now = now + wait
  while events[1] and events[1][1] <= now do
    local what = table.remove(events, 1)[2]
    if what == "press" then presses = presses + 1 end
    if what == "arm" then armed = true end
    if what == "disarm" then armed = false end
  end
  update, wait = update()
end
)lua";

struct PlayedPulse {
  double time = 0.0;  // [ms]
  int channel = 0, pulse = 0, timeout = 0;
};

// What plan.lua plays when this happens; what it says goes to `said`.
std::vector<PlayedPulse> Play(const PlanInputs& inputs,
                              const std::vector<std::string>& events,
                              std::string* said) {
  const std::string stand_in = WriteTestFile(inputs.folder / "stand_in.lua", kStandIn).string();
  ChildCommand lua = {.program = FATHOM_LUA, .arguments = {stand_in, inputs.At("plan/plan.lua")}};
  lua.arguments.insert(lua.arguments.end(), events.begin(), events.end());
  const ChildResult result = RunChild(lua);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::vector<PlayedPulse> played;
  std::istringstream lines(result.out);
  said->clear();
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) {
      *said += line + "\n";
      continue;
    }
    PlayedPulse& one = played.emplace_back();
    std::istringstream(line) >> one.time >> one.channel >> one.pulse >> one.timeout;
  }
  return played;
}

// What is played is pulses.csv, each row from its stamp on, and neutral in the end.
TEST(PlanTool, WritesAScriptThatPlaysThePulsesOnArduSub) {
  if (std::string(FATHOM_LUA).empty()) GTEST_SKIP() << "lua5.4 is not installed";
  const ThrusterInputs inputs;
  RunsWell(inputs.Plan({inputs.heavy, "--voltage=16"}));
  std::string said;
  EXPECT_TRUE(Play(inputs, {"1000:press"}, &said).empty());
  EXPECT_THAT(said, HasSubstr("no start: arm first"));
  EXPECT_TRUE(Play(inputs, {"1000:arm", "2000:press", "no_motor"}, &said).empty());
  EXPECT_THAT(said, HasSubstr("no start: no SERVOn_FUNCTION is 34"));
  EXPECT_TRUE(Play(inputs, {"1000:arm", "2000:press", "no_direction"}, &said).empty());
  EXPECT_THAT(said, HasSubstr("no start: no MOT_2_DIRECTION"));

  const CsvColumns planned = ReadColumns(inputs.At("plan/pulses.csv"));
  const std::vector<PlayedPulse> played = Play(inputs, {"1000:arm", "2000:press"}, &said);
  EXPECT_THAT(said, HasSubstr("plan.lua: started\n# plan.lua: done, neutral\n"));
  // All eight motors, every 20 ms over 42 s, and at the end.
  ASSERT_EQ(played.size(), 8U * (42U * 50U + 1U));
  std::size_t row = 0;
  for (std::size_t i = 0; i < played.size(); ++i) {
    const std::size_t motor = i % 8;
    const double elapsed = played[i].time - 2000.0;
    EXPECT_EQ(played[i].channel, static_cast<int>(motor) + 2);
    while (row + 1 < planned.rows.size() && 1e3 * planned.rows[row + 1][0] <= elapsed + 1e-6) ++row;
    const double pulse = planned.rows[row][1 + motor];
    ASSERT_EQ(played[i].pulse, motor == 2 ? 3000.0 - pulse : pulse) << elapsed << " ms";
    EXPECT_EQ(played[i].timeout, 200);
  }
  EXPECT_EQ(played.back().time, 2000.0 + 42000.0);
  EXPECT_EQ(row, planned.rows.size() - 1);
}

TEST(PlanTool, WritesAScriptThatStopsAtNeutral) {
  if (std::string(FATHOM_LUA).empty()) GTEST_SKIP() << "lua5.4 is not installed";
  const ThrusterInputs inputs;
  RunsWell(inputs.Plan({inputs.heavy, "--voltage=16"}));
  const std::vector<std::pair<std::string, std::string>> ways = {
      {"press", "stopped by the button, neutral"}, {"disarm", "stopped: disarmed, neutral"}};
  for (const auto& [event, words] : ways) {
    std::string said;
    const std::vector<PlayedPulse> played =
        Play(inputs, {"1000:arm", "2000:press", "9000:" + event}, &said);
    EXPECT_THAT(said, HasSubstr(words));
    ASSERT_GT(played.size(), 8U);
    EXPECT_EQ(played.back().time, 9000.0) << event;  // nothing behind it
    for (std::size_t i = played.size() - 8; i < played.size(); ++i) {
      EXPECT_EQ(played[i].time, 9000.0);
      EXPECT_EQ(played[i].pulse, 1500);
    }
  }
}

// `luac -p`: the whole of it, also what no run comes by.
TEST(PlanTool, WritesAScriptThatParses) {
  if (std::string(FATHOM_LUAC).empty()) GTEST_SKIP() << "luac of lua5.4 is not installed";
  const ThrusterInputs inputs;
  RunsWell(inputs.Plan({inputs.heavy, "--voltage=16"}));
  const ChildResult result =
      RunChild({.program = FATHOM_LUAC, .arguments = {"-p", inputs.At("plan/plan.lua")}});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(PlanTool, RefusesWhatTheThrustersCannotGive) {
  const ThrusterInputs inputs;
  const auto refusal = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"--model=" + inputs.model,
                                          "--limits=" + inputs.tank,
                                          "--duration=42",
                                          "--out=" + inputs.At("plan")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ExpectRefusal("fathom_plan", arguments, inputs.folder);
  };
  EXPECT_THAT(refusal({inputs.heavy}), HasSubstr("--voltage: is missing"));
  EXPECT_THAT(refusal({"--voltage=16"}), HasSubstr("--voltage: goes with --vehicle"));
  EXPECT_THAT(refusal({"--vehicle=" + inputs.vehicle}),
              HasSubstr(inputs.vehicle + ": has no thrusters"));
  WriteTestFile(inputs.tank, "force: 140\n");
  // 39.9 N of four thrusters at 45 degrees.
  EXPECT_THAT(refusal({inputs.heavy, "--voltage=16"}),
              HasSubstr(inputs.tank + ": key 'force' is 140 N, expected at most 112.853: the "
                                      "thrusters of"));
  WriteTestFile(inputs.tank, "force: 12\nthruster_force: 4\n");
  EXPECT_THAT(refusal({inputs.heavy, "--voltage=16"}), HasSubstr("give surge -11.31 to 11.31 N"));
  EXPECT_THAT(refusal({}), HasSubstr(inputs.tank + ": key 'thruster_force' goes with --vehicle"));
}

// The arguments of the fathom_plan command that a tool printed on the line that begins so.
std::vector<std::string> HintedArguments(const std::string& out, const std::string& beginning) {
  const std::string start = "\n" + beginning + ": fathom_plan ";
  const std::size_t at = out.find(start);
  if (at == std::string::npos) return {};
  std::istringstream words(
      out.substr(at + start.size(), out.find('\n', at + 1) - at - start.size()));
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) arguments.push_back(word);
  return arguments;
}

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
  const std::string beginning = "next, to plan the deciding run";
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
      HintedArguments(check.out, "then, to plan the run that tells most of the rest");
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

  const std::string start = "next, to fit the chosen stretches alone: fathom_identify ";
  const std::size_t at = run.out.find(start);
  ASSERT_NE(at, std::string::npos) << run.out;
  std::istringstream words(
      run.out.substr(at + start.size(), run.out.find('\n', at) - at - start.size()));
  std::vector<std::string> arguments = {"--model=" + inputs.At("part.json")};
  for (std::string word; words >> word;) arguments.push_back(word);
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
  EXPECT_THAT(refusal({"--model=" + inputs.model,
                       "--limits=" + inputs.tank,
                       "--duration=42",
                       "--json=" + inputs.At("dives.json")}),
              HasSubstr("--json: goes with --ordinary"));
  EXPECT_THAT(refusal({"--ordinary", log, "--held_out=0:100"}),
              HasSubstr("--held_out: takes all of the data"));
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
  WriteTestFile(inputs.tank, "force: 12\ndistance: {back: -1}\n");
  EXPECT_THAT(refusal({model, limits, "--duration=60"}),
              HasSubstr(inputs.tank + ":2: key 'distance.back' is "));
}

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

  void Identify(const std::string& log, const std::string& to) const {
    RunsWell("fathom_identify",
             {"--log=" + At(log),
              "--dofs=surge,sway,yaw",
              "--structure=coriolis",
              "--free=inertia.sway.yaw",
              "--model=" + to});
  }

  ToolRun Plan(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"--model=" + model, "--limits=" + lake};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunToolBinary("fathom_plan", arguments);
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
  const ToolRun without = inputs.Plan({"--duration=20"});
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_THAT(without.err, HasSubstr(inputs.lake + ": key 'thruster_force' goes with --vehicle"));
}

// A verdict by hand: of the coupling that the model holds, left open against others.
TEST(PlanTool, PlansAWrenchThatTellsTheCausesOfACoupledVerdictApart) {
  const CoupledInputFiles inputs;
  const auto verdict_of = [&](const std::string& verdict) {
    const std::string text = R"({"schema": "fathom-verdict-2", "verdict": ")" + verdict +
                             R"(", "causes": [{"entry": "inertia.sway.yaw", "alternatives": )"
                             R"(["linear_damping.sway.yaw", "thrust_gain.port"]}], "model": )" +
                             TextOf(inputs.model) + "}";
    return WriteTestFile(inputs.folder / (verdict + ".json"), text).string();
  };
  const ToolRun run = RunsWell(RunToolBinary("fathom_plan",
                                             {"--verdict=" + verdict_of("ambiguous"),
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

  const ToolRun model = RunsWell(RunToolBinary(
      "fathom_plan",
      {"--verdict=" + verdict_of("explained"), "--limits=" + inputs.lake, "--duration=30"}));
  EXPECT_EQ(model.out, RunsWell(inputs.Plan({"--duration=30"})).out);
}

TEST(PlanTool, RefusesWhatACoupledModelIsNotPlannedWith) {
  const CoupledInputFiles inputs;
  const auto refused = [&](const std::vector<std::string>& flags, const std::string& why) {
    const ToolRun run = inputs.Plan(flags);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr(why));
  };
  refused({"--duration=30", inputs.vehicle}, "planar_rov.yaml: has no thrusters, expected some");
  refused({"--duration=30", "--voltage=16"}, "--voltage: goes with --vehicle");
  refused({"--duration=30", "--log=" + inputs.At("first")}, "--log: goes with a model of one DOF");
  refused({"--duration=1"}, "--duration: is 1 s, expected 5 to 3600 s.");
  refused({}, "--duration: is missing, expected seconds, or `minutes` in ");
  refused({"--duration=30", "--dofs=surge,heave"}, "--dofs: names heave, which ");
  const ToolRun open = RunToolBinary("fathom_plan", {"--model=" + inputs.model, "--duration=30"});
  EXPECT_EQ(open.exit_code, 1);
  EXPECT_THAT(open.err, HasSubstr("--limits: is missing, expected a limits file"));
  WriteTestFile(inputs.lake, "force: {surge: 40}\ndistance: {back: 0.001, ahead: 0.001}\n");
  const ToolRun none = inputs.Plan({"--duration=30"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("No command was found that keeps the limits"));
}

}  // namespace
}  // namespace fathom
