// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/moos_map.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

bool HasVariable(const Contents& contents, std::string_view name) {
  return std::any_of(contents.channels.begin(), contents.channels.end(), [&](const Channel& c) {
    return c.name == name && c.count > 1;
  });
}

std::string ColumnLine(const char* column, const char* variable, const char* rest) {
  return fmt::format("  {}: {{channel: {}, field: value, {}\n", column, variable, rest);
}

std::string CommandOfMoos(bool has_thrust, bool has_rudder) {
  if (!has_thrust && !has_rudder) {
    return "# command: {channel: ..., tau_surge: value}  # no DESIRED_THRUST: which variable is "
           "it?\n";
  }
  std::string text;
  if (has_rudder) text += "dof: [surge, sway, yaw]\n";
  if (has_thrust) text += "command_unit: \"%\"  # of full thrust, not N\n";
  text += "command:  # what was asked for. Is there a variable of what was done?\n";
  if (has_thrust) text += "  tau_surge: {channel: DESIRED_THRUST, field: value}\n";
  if (has_rudder) {
    text +=
        "  # Is it in degrees, or in per cent of the largest angle? Whether a positive angle turns "
        "to\n"
        "  # starboard is yours to know: the fin's axis in the vehicle file, or scale: -1, says "
        "it.\n" +
        ColumnLine("fin_rudder", "DESIRED_RUDDER", "unit: deg}");
  }
  return text;
}

}  // namespace

SuggestedMap MoosMap(const Contents& contents) {
  const auto has = [&](std::string_view name) { return HasVariable(contents, name); };
  SuggestedMap map;
  map.text = "# By the names and units of MOOS-IvP. Look at each line.\n";
  map.text += CommandOfMoos(has("DESIRED_THRUST"), has("DESIRED_RUDDER"));
  if (has("NAV_SPEED")) {
    map.text +=
        "velocity:\n  # Over ground, not surge: with the current and the drift to the side, and "
        "mostly without a sign.\n" +
        ColumnLine("u", "NAV_SPEED", "unit: m/s}");
  }
  const bool has_position = has("NAV_X") && has("NAV_Y");
  const bool has_yaw = has("NAV_HEADING") || has("NAV_YAW");
  if (has_yaw || has("NAV_DEPTH")) {
    map.text += "pose:\n  frame: NED\n";
    if (has_yaw && has_position) {
      map.text += ColumnLine("x", "NAV_Y", "unit: m}  # to the north");
      map.text += ColumnLine("y", "NAV_X", "unit: m}  # to the east");
    }
    if (has("NAV_DEPTH")) map.text += ColumnLine("z", "NAV_DEPTH", "unit: m}");
    if (has("NAV_HEADING")) {
      map.text += ColumnLine("yaw", "NAV_HEADING", "unit: deg}");
    } else if (has_yaw) {
      map.text += ColumnLine("yaw", "NAV_YAW", "unit: rad, scale: -1}  # counter-clockwise");
    }
  }
  if (!has_yaw) {
    map.text +=
        "# pose: {channel: ..., yaw: value}  # no NAV_HEADING or NAV_YAW, which x and y need: "
        "which is "
        "it?\n";
  }
  return map;
}

}  // namespace fathom
