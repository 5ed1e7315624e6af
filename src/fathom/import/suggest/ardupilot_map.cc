// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/ardupilot_map.h"

#include "fathom/import/suggest/autopilot_readiness.h"
#include "fathom/import/suggest/channel_facts.h"
#include "fathom/import/suggest/motor_outputs.h"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// RCOU holds C1 to C14; RCO2 and RCO3 of newer logs hold those behind.
std::optional<FieldPlace> PlaceOfOutput(const Contents& contents, int output) {
  const std::string field = fmt::format("C{}", output);
  for (const char* type : {"RCOU", "RCO2", "RCO3"}) {
    const std::string channel = FirstChannelOf(contents, type);
    if (HasField(contents, channel, field)) return FieldPlace{channel, field};
  }
  return std::nullopt;
}

// The lines of the command.
std::string ArduPilotCommandText(const Recording& recording,
                                 const std::string& outputs,
                                 const MotorOutputs& motors,
                                 const std::optional<Vehicle>& vehicle) {
  const Contents& contents = recording.contents();
  std::string text = fmt::format("command:\n  channel: {}\n  unit: us\n", outputs);
  const std::string battery = FirstChannelOf(contents, "BAT");
  if (HasField(contents, battery, "Volt") && IsEverAbove0(recording, battery, "Volt")) {
    text += fmt::format("  voltage: {{channel: \"{}\", field: Volt}}\n", battery);
  } else {
    text += "  voltage: 16  # the log measures none: what was it?\n";
  }
  const int num_thrusters =
      static_cast<int>(vehicle ? vehicle->thrusters.size() : motors.motors.size());
  return text + ThrusterLines(motors, num_thrusters, outputs);
}

std::string MotionText(const Contents& contents, const std::string& ekf) {
  std::string text =
      fmt::format("velocity:\n  channel: \"{0}\"\n  frame: NED\n  u: VN\n  v: VE\n  w: VD\n", ekf);
  const std::string imu = FirstChannelOf(contents, "IMU");
  if (HasField(contents, imu, "GyrX")) {
    const char* fields[] = {"GyrX", "GyrY", "GyrZ"};
    const char* columns[] = {"p", "q", "r"};
    for (int i = 0; i < 3; ++i) {
      text += fmt::format("  {}: {{channel: \"{}\", field: {}}}\n", columns[i], imu, fields[i]);
    }
  }
  return text + fmt::format(
                    "pose:\n  channel: \"{}\"\n  frame: NED\n  x: PN\n  y: PE\n  z: PD\n"
                    "  roll: Roll\n  pitch: Pitch\n  yaw: Yaw\n",
                    ekf);
}

}  // namespace

SuggestedMap ArdupilotMap(const Recording& recording, const std::optional<Vehicle>& vehicle) {
  const Contents& contents = recording.contents();
  SuggestedMap map;
  map.text =
      "# A log of ArduSub. The motion is its EKF's: without a DVL or a camera aiding it, position\n"
      "# and horizontal speed are not measured at all.\n";
  const std::string outputs = FirstChannelOf(contents, "RCOU");
  const MotorOutputs motors =
      outputs.empty()
          ? MotorOutputs()
          : MotorOutputsOf(recording, [&](int output) { return PlaceOfOutput(contents, output); });
  const int num_outputs = static_cast<int>(motors.motors.size());
  const std::optional<Vehicle> driven = IfDriven(vehicle, num_outputs);
  if (!driven)
    map.text += "vehicle: vehicle.yaml  # of your vehicle; its thrusters in this order\n";
  std::string ekf = FirstChannelOf(contents, "XKF1");
  if (ekf.empty()) ekf = FirstChannelOf(contents, "NKF1");
  if (!outputs.empty()) map.text += ArduPilotCommandText(recording, outputs, motors, driven);
  if (!ekf.empty()) map.text += MotionText(contents, ekf);
  if (outputs.empty()) map.text += "# no RCOU: the log has no thruster outputs.\n";
  if (ekf.empty()) map.text += "# no XKF1 or NKF1: the log has no motion.\n";
  JudgeReadiness(!outputs.empty() && !ekf.empty(), num_outputs, vehicle, &map);
  TellUnknownOutputs(motors, &map);
  return map;
}

}  // namespace fathom
