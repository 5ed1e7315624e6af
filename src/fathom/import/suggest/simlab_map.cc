// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/simlab_map.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

struct SimlabColumn {
  const char* column;  // of a log
  const char* field;
  const char* unit;
};

struct SimlabStream {
  const char* name;
  const char* frame;
  std::vector<SimlabColumn> columns;
};

const std::vector<SimlabStream>& Streams() {
  static const std::vector<SimlabStream> kStreams = {
      {"command",
       "FRD",
       {{"tau_surge", "base_x_force", "N"},
        {"tau_sway", "base_y_force", "N"},
        {"tau_heave", "base_z_force", "N"},
        {"tau_roll", "base_x_torque", "Nm"},
        {"tau_pitch", "base_y_torque", "Nm"},
        {"tau_yaw", "base_z_torque", "Nm"}}},
      {"velocity",
       "FRD",
       {{"u", "velocity_estimate.x", "m/s"},
        {"v", "velocity_estimate.y", "m/s"},
        {"w", "velocity_estimate.z", "m/s"},
        {"p", "angular_velocity_estimate.x", "rad/s"},
        {"q", "angular_velocity_estimate.y", "rad/s"},
        {"r", "angular_velocity_estimate.z", "rad/s"}}},
      {"pose",
       "NED",
       {{"x", "position_estimate.x", "m"},
        {"y", "position_estimate.y", "m"},
        {"z", "position_estimate.z", "m"},
        {"roll", "roll_estimate", "rad"},
        {"pitch", "pitch_estimate", "rad"},
        {"yaw", "yaw_estimate", "rad"}}}};
  return kStreams;
}

bool Has(const Channel& channel, std::string_view name) {
  return std::any_of(channel.fields.begin(), channel.fields.end(), [&](const Field& field) {
    return field.name == name;
  });
}

bool HasAll(const Channel& channel) {
  for (const SimlabStream& stream : Streams()) {
    for (const SimlabColumn& column : stream.columns) {
      if (!Has(channel, column.field)) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<SuggestedMap> SimlabMap(const Contents& contents) {
  const auto& channels = contents.channels;
  const auto table = std::find_if(channels.begin(), channels.end(), HasAll);
  if (table == channels.end()) return std::nullopt;
  SuggestedMap map;
  map.is_ready = true;
  map.text = "# By the columns of uvms-simlab: the wrench on the body, and the estimated state.\n";
  for (const SimlabStream& stream : Streams()) {
    map.text += fmt::format("{}:\n", stream.name);
    if (channels.size() > 1) map.text += fmt::format("  channel: \"{}\"\n", table->name);
    map.text += fmt::format("  frame: {}\n", stream.frame);
    for (const SimlabColumn& column : stream.columns) {
      map.text +=
          fmt::format("  {}: {{field: {}, unit: {}}}\n", column.column, column.field, column.unit);
    }
  }
  return map;
}

}  // namespace fathom
