// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The script for ArduSub, played by a stand-in.

#include "fathom/process/run_child.h"

#include <sstream>
#include <utility>

#include "plan_inputs.h"
#include "saved_files.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

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
  inputs.PlanThrusters();
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
  inputs.PlanThrusters();
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
  inputs.PlanThrusters();
  const ChildResult result =
      RunChild({.program = FATHOM_LUAC, .arguments = {"-p", inputs.At("plan/plan.lua")}});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace
}  // namespace fathom
