// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/suggested_map.h"

#include <nlohmann/json.hpp>

namespace fathom {

bool SuggestedMap::NamesAStream() const {
  for (const char* const stream : {"command:", "velocity:", "pose:", "camera:"}) {
    if (text.starts_with(stream) || text.find(std::string("\n") + stream) != std::string::npos) {
      return true;
    }
  }
  return false;
}

std::string WhatIsLookedFor(std::string_view format) {
  if (format == "ros1_bag" || format == "mcap" || format == "rosbag2") {
    return "two messages or more of geometry_msgs (Wrench, Twist, Pose), nav_msgs/Odometry or "
           "mavros_msgs/RCOut";
  }
  if (format == "dataflash") return "outputs (RCOU) or motion (XKF1, NKF1)";
  if (format == "ulog") return "outputs (actuator_motors, actuator_outputs) or motion of PX4";
  if (format == "tlog") return "SERVO_OUTPUT_RAW, or LOCAL_POSITION_NED and ATTITUDE";
  if (format == "alog") return "DESIRED_THRUST, DESIRED_RUDDER, NAV_SPEED, NAV_HEADING, NAV_DEPTH";
  if (format == "pocolog") return "types of Rock's base/samples: joints, wrenches, body states";
  return "fields that are called as a command (tau_surge, force, thrust), a velocity (u, vx, "
         "speed, "
         "r, yaw_rate) or a pose (x, y and yaw or qw) often is, in a unit of that kind or in none";
}

std::string FormatSuggestion(const SuggestedMap& map) {
  using Json = nlohmann::ordered_json;
  return Json{{"schema", "fathom-suggestion-1"},
              {"ready", map.is_ready},
              {"needs_vehicle", map.needs_vehicle},
              {"map", map.text}}
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

}  // namespace fathom
