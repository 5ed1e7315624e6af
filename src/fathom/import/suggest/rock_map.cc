// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/rock_map.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr const char* kForces[] = {"tau_surge", "tau_sway", "tau_heave"};
constexpr const char* kTorques[] = {"tau_roll", "tau_pitch", "tau_yaw"};

bool HasField(const Channel& channel, std::string_view name) {
  return std::any_of(channel.fields.begin(), channel.fields.end(), [&](const Field& field) {
    return field.name == name;
  });
}

// Types that are marshalled by way of another are called as that, with "_m".
std::string_view WithoutMarshalling(std::string_view type) {
  return type.ends_with("_m") ? type.substr(0, type.size() - 2) : type;
}

// The channel of this type that has the field, with the most samples; null if there is none.
const Channel* Find(const Contents& contents, std::string_view type, std::string_view field) {
  const Channel* best = nullptr;
  for (const Channel& channel : contents.channels) {
    if (WithoutMarshalling(channel.type) != type || channel.count < 2) continue;
    if (!HasField(channel, field)) continue;
    if (best == nullptr || channel.count > best->count) best = &channel;
  }
  return best;
}

std::string Head(const char* stream, const Channel& channel, const char* frame) {
  std::string text = fmt::format(
      "{}:\n  channel: \"{}\"  # {}\n  frame: {}\n", stream, channel.name, channel.type, frame);
  const char* time = HasField(channel, "time") ? "time" : nullptr;
  if (time != nullptr) text += "  time: time  # of the sample itself, not that of its logging\n";
  return text;
}

std::string CommandOf(const Contents& contents) {
  if (const Channel* joints = Find(contents, "/base/samples/Joints", "elements[5].effort")) {
    std::string text = Head("command", *joints, "FLU");
    for (int i = 0; i < 6; ++i) {
      text += fmt::format("  {}: {{field: \"elements[{}].effort\", unit: {}}}\n",
                          i < 3 ? kForces[i] : kTorques[i - 3],
                          i,
                          i < 3 ? "N" : "Nm");
    }
    return text;
  }
  if (const Channel* command =
          Find(contents, "/base/commands/LinearAngular6DCommand", "linear.data[0]")) {
    std::string text = Head("command", *command, "FLU");
    for (int i = 0; i < 3; ++i) {
      text += fmt::format("  {}: {{field: \"linear.data[{}]\", unit: N}}\n", kForces[i], i);
    }
    for (int i = 0; i < 3; ++i) {
      text += fmt::format("  {}: {{field: \"angular.data[{}]\", unit: Nm}}\n", kTorques[i], i);
    }
    return text;
  }
  return "# command: {channel: ..., tau_surge: ...}  # no six efforts: which stream is the "
         "thrust?\n";
}

}  // namespace

SuggestedMap RockMap(const Contents& contents) {
  SuggestedMap map;
  map.text = "# By the types of the streams and Rock's axes. Look at each line.\n";
  map.text += CommandOf(contents);
  const Channel* state = Find(contents, "/base/samples/RigidBodyState", "position.data[0]");
  if (state == nullptr) {
    map.text +=
        "# pose: {channel: ..., x: ...}  # no RigidBodyState: which stream is the motion?\n";
    return map;
  }
  map.text += Head("pose", *state, "NWU");
  for (int i = 0; i < 3; ++i) {
    map.text += fmt::format("  {}: {{field: \"position.data[{}]\", unit: m}}\n", "xyz"[i], i);
  }
  for (int i = 0; i < 3; ++i) {
    map.text += fmt::format("  q{}: \"orientation.im[{}]\"\n", "xyz"[i], i);
  }
  map.text += "  qw: \"orientation.re\"\n";
  map.text +=
      "# The velocity of a RigidBodyState is along the axes of the world by Rock's rule, and "
      "along\n"
      "# those of the body in some tasks. Only in these is it one for the log:\n"
      "# velocity:\n";
  map.text += fmt::format("#   channel: \"{}\"\n#   frame: FLU\n", state->name);
  for (int i = 0; i < 3; ++i) {
    map.text += fmt::format("#   {}: {{field: \"velocity.data[{}]\", unit: m/s}}\n", "uvw"[i], i);
  }
  return map;
}

}  // namespace fathom
