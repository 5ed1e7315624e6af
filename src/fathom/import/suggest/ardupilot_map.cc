// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/ardupilot_map.h"

#include "fathom/import/suggest/autopilot_readiness.h"
#include "fathom/import/suggest/channel_facts.h"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kMostRcouOutputs = 14;  // C1 to C14 of RCOU

// How many outputs, from the first on, ever send a pulse.
int NumRcouOutputs(const Recording& recording, const std::string& channel) {
  std::vector<std::string> fields;
  for (int i = 1; i <= kMostRcouOutputs; ++i) fields.push_back(fmt::format("C{}", i));
  return NumThatReach(recording, channel, fields, kShortestPulse);
}

// Whether ArduSub turns the pulses of this motor around: MOT_n_DIRECTION is -1.
bool IsReversed(const Contents& contents, int motor) {
  const auto direction = contents.parameters.find(fmt::format("MOT_{}_DIRECTION", motor));
  return direction != contents.parameters.end() && direction->second < 0.0;
}

// The lines of the command.
std::string ArduPilotCommandText(const Recording& recording,
                                 const std::string& outputs,
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
      vehicle ? static_cast<int>(vehicle->thrusters.size()) : NumRcouOutputs(recording, outputs);
  for (int i = 1; i <= num_thrusters; ++i) {
    text += IsReversed(contents, i)
                ? fmt::format(
                      "  thruster_{0}: {{field: C{0}, scale: -1, offset: 3000}}  "
                      "# MOT_{0}_DIRECTION is -1\n",
                      i)
                : fmt::format("  thruster_{0}: C{0}\n", i);
  }
  return text;
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
  const int num_outputs = outputs.empty() ? 0 : NumRcouOutputs(recording, outputs);
  const std::optional<Vehicle> driven = IfDriven(vehicle, num_outputs);
  if (!driven)
    map.text += "vehicle: vehicle.yaml  # of your vehicle; its thrusters in this order\n";
  std::string ekf = FirstChannelOf(contents, "XKF1");
  if (ekf.empty()) ekf = FirstChannelOf(contents, "NKF1");
  if (!outputs.empty()) map.text += ArduPilotCommandText(recording, outputs, driven);
  if (!ekf.empty()) map.text += MotionText(contents, ekf);
  if (outputs.empty()) map.text += "# no RCOU: the log has no thruster outputs.\n";
  if (ekf.empty()) map.text += "# no XKF1 or NKF1: the log has no motion.\n";
  JudgeReadiness(!outputs.empty() && !ekf.empty(), num_outputs, vehicle, &map);
  return map;
}

}  // namespace fathom
