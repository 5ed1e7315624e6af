// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/ardusub_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// SERVOn_FUNCTION of motors 1 to 12.
constexpr std::array<int, 12> kMotorFunctions = {33, 34, 35, 36, 37, 38, 39, 40, 82, 83, 84, 85};
constexpr double kLongestUpdate = 20.0;  // between two calls of the script [ms]

// Milliseconds from the start and the pulses from then on, where these change.
std::string RowsOfScript(const PlannedThrusts& plan, const ThrusterSet& thrusters) {
  std::string rows;
  std::vector<int> last;
  // The last row of a command is its end.
  for (std::size_t i = 0; i + 1 < plan.time.size(); ++i) {
    std::vector<int> pulses = thrusters.PulsesOf(plan.thrust[i]);
    if (pulses == last) continue;
    rows +=
        fmt::format("  {{{}, {}}},\n", std::lround(1e3 * plan.time[i]), fmt::join(pulses, ", "));
    last = std::move(pulses);
  }
  return rows;
}

// The part that is the same for all plans. What the plan says stands in front of it.
constexpr const char* kPlayer = R"lua(
local channels = {}    -- outputs, counted from 0
local reversed = {}    -- motors with MOT_n_DIRECTION below 0
local started = nil    -- when the run began
local row = 1

local function say(text)
  gcs:send_text(6, "plan.lua: " .. text)
end

-- What is missing; nil: nothing.
local function find_motors()
  for k = 1, #FUNCTIONS do
    channels[k] = SRV_Channels:find_channel(FUNCTIONS[k])
    if channels[k] == nil then
      return "no SERVOn_FUNCTION is " .. FUNCTIONS[k]
    end
    local direction = param:get("MOT_" .. k .. "_DIRECTION")
    if direction == nil then
      return "no MOT_" .. k .. "_DIRECTION"
    end
    reversed[k] = direction < 0
  end
  return nil
end

-- Pulses of all motors; `first`: the place of motor 1 among them.
local function play(pulses, first)
  for k = 1, #FUNCTIONS do
    local pulse = pulses[first + k - 1]
    if reversed[k] then
      pulse = 3000 - pulse
    end
    SRV_Channels:set_output_pwm_chan_timeout(channels[k], pulse, TIMEOUT_MS)
  end
end

local function stop(why)
  play(NEUTRAL, 1)
  started = nil
  say(why .. ", neutral")
end

local function start()
  if not arming:is_armed() then
    say("no start: arm first")
    return
  end
  local missing = find_motors()
  if missing ~= nil then
    say("no start: " .. missing)
    return
  end
  started = millis()
  row = 1
  say("started")
end

local function update()
  local is_pressed = sub:get_and_clear_button_count(BUTTON) > 0
  if started == nil then
    if is_pressed then
      start()
    end
    if started == nil then
      return update, UPDATE_MS
    end
  elseif is_pressed then
    stop("stopped by the button")
    return update, UPDATE_MS
  end
  if not arming:is_armed() then
    stop("stopped: disarmed")
    return update, UPDATE_MS
  end
  local elapsed = (millis() - started):toint()
  if elapsed >= END_MS then
    stop("done")
    return update, UPDATE_MS
  end
  while row < #ROWS and elapsed >= ROWS[row + 1][1] do
    row = row + 1
  end
  play(ROWS[row], 2)
  return update, UPDATE_MS
end

say("ready: arm, then press Script 1")
return update, UPDATE_MS
)lua";

}  // namespace

bool HasArduSubScript(const ThrusterSet& thrusters) {
  return thrusters.HasPulses() && thrusters.names.size() <= kMotorFunctions.size();
}

std::string FormatArduSubScript(std::string_view what,
                                const PlannedThrusts& plan,
                                const ThrusterSet& thrusters) {
  const std::vector<int> functions(
      kMotorFunctions.begin(),
      kMotorFunctions.begin() + static_cast<std::ptrdiff_t>(thrusters.names.size()));
  const double hold = 1e3 * (plan.time[1] - plan.time[0]);
  const long update = std::max(1L, std::lround(std::min(kLongestUpdate, hold)));
  std::string text = fmt::format(
      "-- Planned by fathom_plan: {} for {:g} s, at {:g} V. Thruster k is ArduSub's motor k.\n"
      "--\n"
      "-- Start: arm in MANUAL, leave the sticks alone, press the joystick button that has the "
      "function\n"
      "-- Script 1. Stop at any time: press it again, or disarm. At the end, and at a stop, all "
      "motors go\n"
      "-- to neutral and the pilot has them back. If the script dies, they are the pilot's after "
      "TIMEOUT_MS.\n"
      "-- It plays open loop: nothing keeps the vehicle off a wall but you.\n"
      "--\n"
      "-- Install: SCR_ENABLE = 1, this file into APM/scripts on the card, restart. Remove it "
      "afterwards.\n"
      "\n"
      "local BUTTON = 1         -- Script 1\n"
      "local UPDATE_MS = {}\n"
      "local TIMEOUT_MS = {}\n"
      "local END_MS = {}\n"
      "local FUNCTIONS = {{{}}} -- SERVOn_FUNCTION of the motors\n"
      "local NEUTRAL = {{{}}} -- [us]\n"
      "local ROWS = {{ -- milliseconds from the start, then the pulses from then on [us]\n",
      what,
      plan.time.back(),
      thrusters.voltage,
      update,
      10 * update,
      std::lround(1e3 * plan.time.back()),
      fmt::join(functions, ", "),
      fmt::join(thrusters.PulsesOf(std::vector<double>(thrusters.names.size(), 0.0)), ", "));
  return text + RowsOfScript(plan, thrusters) + "}\n" + kPlayer;
}

}  // namespace fathom
