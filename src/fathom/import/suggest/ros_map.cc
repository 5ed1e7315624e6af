// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/ros_map.h"

#include "fathom/base/plural.h"
#include "fathom/import/ros/known_types.h"
#include "fathom/import/suggest/channel_facts.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// A type that holds what is looked for, and before which part of its paths.
struct TypePath {
  std::string_view type;
  std::string_view prefix;
};

// The surest first.
constexpr TypePath kWrenches[] = {{"geometry_msgs/WrenchStamped", "wrench."},
                                  {"geometry_msgs/Wrench", ""}};
constexpr TypePath kTwists[] = {{"nav_msgs/Odometry", "twist.twist."},
                                {"geometry_msgs/TwistStamped", "twist."},
                                {"geometry_msgs/TwistWithCovarianceStamped", "twist.twist."},
                                {"geometry_msgs/Twist", ""}};
constexpr TypePath kPoses[] = {{"nav_msgs/Odometry", "pose.pose."},
                               {"geometry_msgs/PoseStamped", "pose."},
                               {"geometry_msgs/PoseWithCovarianceStamped", "pose.pose."},
                               {"geometry_msgs/Pose", ""}};

constexpr TypePath kPulses[] = {{"mavros_msgs/RCOut", ""}};
constexpr TypePath kBatteries[] = {{"sensor_msgs/BatteryState", ""}};

constexpr int kMostMavrosOutputs = 16;  // of mavros

// What was found: the channel with the most messages of the surest type there is.
struct Choice {
  const Channel* channel = nullptr;
  std::string_view prefix;
  std::size_t num_others = 0;  // channels of any of the types that were not taken
};

template <typename Types>
Choice Choose(const Contents& contents, const Types& types) {
  Choice choice;
  std::size_t num_all = 0;
  for (const TypePath& wanted : types) {
    const Channel* best = nullptr;
    for (const Channel& channel : contents.channels) {
      if (WithoutMsg(channel.type) != wanted.type || channel.count < 2) continue;
      ++num_all;
      if (best == nullptr || channel.count > best->count) best = &channel;
    }
    if (choice.channel == nullptr && best != nullptr) choice = {best, wanted.prefix, 0};
  }
  choice.num_others = num_all - (choice.channel == nullptr ? 0 : 1);
  return choice;
}

std::string MapLine(std::string_view column,
                    std::string_view prefix,
                    std::string_view field,
                    const char* unit) {
  return fmt::format("  {}: {{field: \"{}{}\", unit: {}}}\n", column, prefix, field, unit);
}

std::string Head(const char* stream, const Choice& choice, const char* frame) {
  std::string text = fmt::format(
      "{}:\n  channel: \"{}\"  # {}", stream, choice.channel->name, choice.channel->type);
  if (choice.num_others > 0) {
    text += fmt::format("; {} may be it", Plural(choice.num_others, "other"));
  }
  return text + fmt::format("\n  frame: {}\n", frame);
}

// The lines of a command that mavros tells as pulses; empty if there are none.
std::string PulsesText(const Recording& recording, const std::optional<Vehicle>& vehicle) {
  const Choice outputs = Choose(recording.contents(), kPulses);
  if (outputs.channel == nullptr) return "";
  std::string text = fmt::format("command:\n  channel: \"{}\"  # {}\n  unit: us\n",
                                 outputs.channel->name,
                                 outputs.channel->type);
  const Choice battery = Choose(recording.contents(), kBatteries);
  if (battery.channel != nullptr && IsEverAbove0(recording, battery.channel->name, "voltage")) {
    text += fmt::format("  voltage: {{channel: \"{}\", field: voltage, unit: V}}\n",
                        battery.channel->name);
  } else {
    text += "  voltage: 16  # the log measures none: what was it?\n";
  }
  std::vector<std::string> fields;
  for (int i = 0; i < kMostMavrosOutputs; ++i) fields.push_back(fmt::format("channels[{}]", i));
  const int num_thrusters =
      vehicle ? static_cast<int>(vehicle->thrusters.size())
              : NumThatReach(recording, outputs.channel->name, fields, kShortestPulse);
  for (int i = 0; i < num_thrusters; ++i) {
    text += fmt::format("  thruster_{}: \"channels[{}]\"\n", i + 1, i);
  }
  return vehicle ? text
                 : "vehicle: vehicle.yaml  # of your vehicle; its thrusters in this order\n" + text;
}

}  // namespace

SuggestedMap RosMap(const Recording& recording, const std::optional<Vehicle>& vehicle) {
  const Contents& contents = recording.contents();
  SuggestedMap map;
  map.text = "# By the types of the topics and ROS's conventions (REP 103). Look at each line.\n";
  const Choice wrench = Choose(contents, kWrenches);
  const Choice twist = Choose(contents, kTwists);
  const Choice pose = Choose(contents, kPoses);
  if (wrench.channel != nullptr) {
    map.text += Head("command", wrench, "FLU");
    const std::string_view p = wrench.prefix;
    map.text += MapLine("tau_surge", p, "force.x", "N") + MapLine("tau_sway", p, "force.y", "N") +
                MapLine("tau_heave", p, "force.z", "N") + MapLine("tau_roll", p, "torque.x", "Nm") +
                MapLine("tau_pitch", p, "torque.y", "Nm") + MapLine("tau_yaw", p, "torque.z", "Nm");
  } else if (const std::string pulses = PulsesText(recording, vehicle); !pulses.empty()) {
    map.text += pulses;
    map.needs_vehicle = !vehicle;
  } else {
    map.text +=
        "# command: {channel: ..., tau_surge: ...}  # no wrench: which topic is the thrust?\n";
  }
  if (twist.channel != nullptr) {
    map.text += Head("velocity", twist, "FLU");
    const std::string_view p = twist.prefix;
    map.text += MapLine("u", p, "linear.x", "m/s") + MapLine("v", p, "linear.y", "m/s") +
                MapLine("w", p, "linear.z", "m/s") + MapLine("p", p, "angular.x", "rad/s") +
                MapLine("q", p, "angular.y", "rad/s") + MapLine("r", p, "angular.z", "rad/s");
  }
  if (pose.channel != nullptr) {
    map.text += Head("pose", pose, "ENU");
    const std::string_view p = pose.prefix;
    map.text += MapLine("x", p, "position.x", "m") + MapLine("y", p, "position.y", "m") +
                MapLine("z", p, "position.z", "m");
    for (const char* part : {"x", "y", "z", "w"}) {
      map.text += fmt::format("  q{0}: \"{1}orientation.{0}\"\n", part, p);
    }
  }
  if (twist.channel == nullptr && pose.channel == nullptr) {
    map.text += "# velocity: {channel: ..., u: ...}  # no twist: which topic is the motion?\n";
  }
  map.is_ready = wrench.channel != nullptr && wrench.num_others == 0 && twist.channel != nullptr &&
                 WithoutMsg(twist.channel->type) == "nav_msgs/Odometry" &&
                 pose.channel == twist.channel && twist.num_others == 0 && pose.num_others == 0;
  return map;
}

}  // namespace fathom
