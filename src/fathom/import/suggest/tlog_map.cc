// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/tlog_map.h"

#include "fathom/import/suggest/autopilot_readiness.h"
#include "fathom/import/suggest/channel_facts.h"
#include "fathom/import/suggest/motor_outputs.h"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNoVoltage = 65535;  // [mV]: "not sent by autopilot", in all 16 bits

std::string TlogCommandText(const Recording& recording,
                            const std::string& outputs,
                            const MotorOutputs& motors,
                            const std::optional<Vehicle>& vehicle) {
  const Contents& contents = recording.contents();
  std::string text = fmt::format("command:\n  channel: \"{}\"\n  unit: us\n", outputs);
  const std::string battery = FirstChannelOf(contents, "SYS_STATUS");
  const std::vector<std::string> voltage = {"voltage_battery"};
  if (!battery.empty() && IsEverAbove0(recording, battery, voltage.front()) &&
      NumThatReach(recording, battery, voltage, kNoVoltage) == 0) {
    text += fmt::format("  voltage: {{channel: \"{}\", field: voltage_battery}}\n", battery);
  } else {
    text += "  voltage: 16  # the log measures none: what was it?\n";
  }
  const int num_thrusters =
      static_cast<int>(vehicle ? vehicle->thrusters.size() : motors.motors.size());
  return text + ThrusterLines(motors, num_thrusters, outputs);
}

std::string MotionText(const std::string& position, const std::string& attitude) {
  return fmt::format(
      "velocity:\n  channel: \"{0}\"\n  frame: NED\n  u: vx\n  v: vy\n  w: vz\n"
      "  p: {{channel: \"{1}\", field: rollspeed}}\n"
      "  q: {{channel: \"{1}\", field: pitchspeed}}\n"
      "  r: {{channel: \"{1}\", field: yawspeed}}\n"
      "pose:\n  channel: \"{0}\"\n  frame: NED\n  x: x\n  y: y\n  z: z\n"
      "  roll: {{channel: \"{1}\", field: roll}}\n"
      "  pitch: {{channel: \"{1}\", field: pitch}}\n"
      "  yaw: {{channel: \"{1}\", field: yaw}}\n",
      position,
      attitude);
}

}  // namespace

SuggestedMap TlogMap(const Recording& recording, const std::optional<Vehicle>& vehicle) {
  const Contents& contents = recording.contents();
  SuggestedMap map;
  map.text =
      "# What a ground station heard. Its stamps are when packets came, a few times a second: the\n"
      "# autopilot's own log (.BIN, .ulg) is better where there is one. The motion is the EKF's:\n"
      "# without a DVL or a camera aiding it, position and horizontal speed are not measured at "
      "all.\n";
  const std::string outputs = FirstChannelOf(contents, "SERVO_OUTPUT_RAW");
  const auto place_of = [&](int output) -> std::optional<FieldPlace> {
    const std::string field = fmt::format("servo{}_raw", output);
    if (!HasField(contents, outputs, field)) return std::nullopt;
    return FieldPlace{outputs, field};
  };
  const MotorOutputs motors =
      outputs.empty() ? MotorOutputs() : MotorOutputsOf(recording, place_of);
  const int num_outputs = static_cast<int>(motors.motors.size());
  const std::optional<Vehicle> driven = IfDriven(vehicle, num_outputs);
  if (!driven)
    map.text += "vehicle: vehicle.yaml  # of your vehicle; its thrusters in this order\n";
  const std::string position = FirstChannelOf(contents, "LOCAL_POSITION_NED");
  const std::string attitude = FirstChannelOf(contents, "ATTITUDE");
  const bool has_motion = !position.empty() && !attitude.empty();
  if (!outputs.empty()) {
    map.text += TlogCommandText(recording, outputs, motors, driven);
  } else {
    map.text += "# no SERVO_OUTPUT_RAW: the log has no thruster outputs.\n";
  }
  if (has_motion) {
    map.text += MotionText(position, attitude);
  } else {
    map.text += "# no LOCAL_POSITION_NED and ATTITUDE: the log has no motion.\n";
  }
  JudgeReadiness(!outputs.empty() && has_motion, num_outputs, vehicle, &map);
  TellUnknownOutputs(motors, &map);
  return map;
}

}  // namespace fathom
