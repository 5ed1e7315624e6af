// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/px4_map.h"

#include "fathom/import/suggest/autopilot_readiness.h"
#include "fathom/import/suggest/channel_facts.h"

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kMostPx4Outputs = 16;  // of actuator_outputs; actuator_motors has 12

// The outputs that may drive thrusters.
struct Px4Outputs {
  std::string channel;  // empty: there are none
  std::string field;    // "control", of which there are several
  std::string unit;
  int count = 0;  // from the first on
};

Px4Outputs OutputsOf(const Recording& recording) {
  const auto outputs = [&](const char* type, const char* field, const char* unit, double least) {
    Px4Outputs found = {FirstChannelOf(recording.contents(), type), field, unit, 0};
    if (found.channel.empty()) return found;
    std::vector<std::string> fields;
    for (int i = 0; i < kMostPx4Outputs; ++i) fields.push_back(fmt::format("{}[{}]", field, i));
    found.count = NumThatReach(recording, found.channel, fields, least);
    return found;
  };
  // A motor that is not there is NaN; one that is there is 0 to 1, or -1 to 1 if it reverses.
  const Px4Outputs motors = outputs("actuator_motors", "control", "1", -1.0);
  return motors.count > 0 ? motors : outputs("actuator_outputs", "output", "us", kShortestPulse);
}

std::string Px4CommandText(const Recording& recording,
                           const Px4Outputs& outputs,
                           const std::optional<Vehicle>& vehicle) {
  std::string text =
      fmt::format("command:\n  channel: \"{}\"\n  unit: {}\n",
                  outputs.channel,
                  outputs.unit == "1" ? "\"1\"  # of full command, -1 to 1" : outputs.unit);
  const std::string battery = FirstChannelOf(recording.contents(), "battery_status");
  if (HasField(recording.contents(), battery, "voltage_v") &&
      IsEverAbove0(recording, battery, "voltage_v")) {
    text += fmt::format("  voltage: {{channel: \"{}\", field: voltage_v, unit: V}}\n", battery);
  } else {
    text += "  voltage: 16  # the log measures none: what was it?\n";
  }
  const int num_thrusters = vehicle ? static_cast<int>(vehicle->thrusters.size()) : outputs.count;
  for (int i = 0; i < num_thrusters; ++i) {
    text += fmt::format("  thruster_{}: \"{}[{}]\"\n", i + 1, outputs.field, i);
  }
  return text;
}

// The rates along the body's axes: of the topic that has them, by its age.
std::string RatesText(const Contents& contents) {
  const std::string rates = FirstChannelOf(contents, "vehicle_angular_velocity");
  const std::string attitude = FirstChannelOf(contents, "vehicle_attitude");
  const std::string sensors = FirstChannelOf(contents, "sensor_combined");
  std::string channel;
  std::array<const char*, 3> fields = {"xyz[0]", "xyz[1]", "xyz[2]"};
  if (HasField(contents, rates, fields[0])) {
    channel = rates;
  } else if (HasField(contents, attitude, "rollspeed")) {
    channel = attitude;
    fields = {"rollspeed", "pitchspeed", "yawspeed"};
  } else if (HasField(contents, sensors, "gyro_rad[0]")) {
    channel = sensors;
    fields = {"gyro_rad[0]", "gyro_rad[1]", "gyro_rad[2]"};
  }
  if (channel.empty()) return {};
  constexpr std::array<const char*, 3> kColumns = {"p", "q", "r"};
  std::string text;
  for (int i = 0; i < 3; ++i) {
    text += fmt::format(
        "  {}: {{channel: \"{}\", field: \"{}\", unit: rad/s}}\n", kColumns[i], channel, fields[i]);
  }
  return text;
}

std::string MotionText(const Contents& contents,
                       const std::string& position,
                       const std::string& attitude) {
  std::string text = fmt::format("velocity:\n  channel: \"{}\"\n  frame: NED\n", position);
  constexpr std::array<const char*, 3> kVelocity = {"u", "v", "w"};
  constexpr std::array<const char*, 3> kSpeeds = {"vx", "vy", "vz"};
  for (int i = 0; i < 3; ++i) {
    text += fmt::format("  {}: {{field: {}, unit: m/s}}\n", kVelocity[i], kSpeeds[i]);
  }
  text += RatesText(contents);
  text += fmt::format("pose:\n  channel: \"{}\"\n  frame: NED\n", position);
  for (const char* axis : {"x", "y", "z"}) {
    text += fmt::format("  {0}: {{field: {0}, unit: m}}\n", axis);
  }
  constexpr std::array<const char*, 4> kParts = {"qw", "qx", "qy", "qz"};
  for (int i = 0; i < 4; ++i) {
    text += fmt::format("  {}: {{channel: \"{}\", field: \"q[{}]\"}}\n", kParts[i], attitude, i);
  }
  return text;
}

}  // namespace

SuggestedMap Px4Map(const Recording& recording, const std::optional<Vehicle>& vehicle) {
  const Contents& contents = recording.contents();
  SuggestedMap map;
  map.text =
      "# A log of PX4. The motion is its EKF's: without a DVL or a camera aiding it, position and\n"
      "# horizontal speed are not measured at all.\n";
  const Px4Outputs outputs = OutputsOf(recording);
  const std::optional<Vehicle> driven = IfDriven(vehicle, outputs.count);
  if (!driven)
    map.text += "vehicle: vehicle.yaml  # of your vehicle; its thrusters in this order\n";
  const std::string position = FirstChannelOf(contents, "vehicle_local_position");
  const std::string attitude = FirstChannelOf(contents, "vehicle_attitude");
  const bool has_motion =
      HasField(contents, position, "vx") && HasField(contents, attitude, "q[0]");
  if (outputs.count > 0) {
    map.text += Px4CommandText(recording, outputs, driven);
  } else {
    map.text +=
        "# no actuator_motors and no pulses in actuator_outputs: the log has no thruster "
        "outputs.\n";
  }
  if (has_motion) {
    map.text += MotionText(contents, position, attitude);
  } else {
    map.text += "# no vehicle_local_position and vehicle_attitude: the log has no motion.\n";
  }
  JudgeReadiness(outputs.count > 0 && has_motion, outputs.count, vehicle, &map);
  return map;
}

}  // namespace fathom
