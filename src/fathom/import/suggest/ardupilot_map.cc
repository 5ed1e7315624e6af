// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/ardupilot_map.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kMostOutputs = 14;        // C1 to C14 of RCOU
constexpr double kShortestPulse = 800;  // [us]: below, an output is off

// The channel of a type, its first instance; empty if there is none.
std::string ChannelOf(const Contents& contents, std::string_view type) {
  for (const Channel& channel : contents.channels) {
    if (channel.type == type && channel.count > 1) return channel.name;
  }
  return {};
}

bool HasField(const Contents& contents, const std::string& channel, std::string_view field) {
  return std::any_of(contents.channels.begin(), contents.channels.end(), [&](const Channel& c) {
    return c.name == channel && std::any_of(c.fields.begin(), c.fields.end(), [&](const Field& f) {
             return f.name == field;
           });
  });
}

// How many outputs, from the first on, ever send a pulse.
int NumOutputs(const Recording& recording, const std::string& channel) {
  Selection selection = {channel, {}};
  for (int i = 1; i <= kMostOutputs; ++i) {
    const std::string field = fmt::format("C{}", i);
    if (HasField(recording.contents(), channel, field)) selection.fields.push_back(field);
  }
  std::vector<double> longest(selection.fields.size(), 0.0);
  recording.Read({&selection, 1}, [&](std::size_t, double, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) longest[i] = std::max(longest[i], values[i]);
  });
  const auto off = std::find_if(
      longest.begin(), longest.end(), [](double pulse) { return pulse < kShortestPulse; });
  return static_cast<int>(off - longest.begin());
}

bool IsAbove0(const Recording& recording, const Selection& selection) {
  bool is_above = false;
  recording.Read({&selection, 1}, [&](std::size_t, double, std::span<const double> values) {
    is_above = is_above || values.front() > 0.0;
  });
  return is_above;
}

// The lines of the command.
std::string CommandText(const Recording& recording,
                        const std::string& outputs,
                        const std::optional<Vehicle>& vehicle) {
  const Contents& contents = recording.contents();
  std::string text = fmt::format("command:\n  channel: {}\n  unit: us\n", outputs);
  const std::string battery = ChannelOf(contents, "BAT");
  if (HasField(contents, battery, "Volt") && IsAbove0(recording, {battery, {"Volt"}})) {
    text += fmt::format("  voltage: {{channel: \"{}\", field: Volt}}\n", battery);
  } else {
    text += "  voltage: 16  # the log measures none: what was it?\n";
  }
  const int num_thrusters =
      vehicle ? static_cast<int>(vehicle->thrusters.size()) : NumOutputs(recording, outputs);
  for (int i = 1; i <= num_thrusters; ++i) text += fmt::format("  thruster_{0}: C{0}\n", i);
  return text;
}

std::string MotionText(const Contents& contents, const std::string& ekf) {
  std::string text =
      fmt::format("velocity:\n  channel: \"{0}\"\n  frame: NED\n  u: VN\n  v: VE\n  w: VD\n", ekf);
  const std::string imu = ChannelOf(contents, "IMU");
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
  if (!vehicle) map.text += "vehicle: ROV.yaml  # of your vehicle; its thrusters in this order\n";
  const std::string outputs = ChannelOf(contents, "RCOU");
  std::string ekf = ChannelOf(contents, "XKF1");
  if (ekf.empty()) ekf = ChannelOf(contents, "NKF1");
  if (!outputs.empty()) map.text += CommandText(recording, outputs, vehicle);
  if (!ekf.empty()) map.text += MotionText(contents, ekf);
  if (outputs.empty()) map.text += "# no RCOU: the log has no thruster outputs.\n";
  if (ekf.empty()) map.text += "# no XKF1 or NKF1: the log has no motion.\n";
  const bool has_both = !outputs.empty() && !ekf.empty();
  map.needs_vehicle = has_both && !vehicle;
  map.is_ready = has_both && vehicle;
  if (map.is_ready && NumOutputs(recording, outputs) < std::ssize(vehicle->thrusters)) {
    map.is_ready = false;
    map.text += fmt::format("# the log drives {} outputs, the vehicle has {} thrusters.\n",
                            NumOutputs(recording, outputs),
                            vehicle->thrusters.size());
  }
  return map;
}

}  // namespace fathom
