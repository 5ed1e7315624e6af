// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/suggest_map.h"

#include "fathom/import/suggest/ardupilot_map.h"
#include "fathom/import/suggest/map_by_names.h"
#include "fathom/import/suggest/moos_map.h"
#include "fathom/import/suggest/px4_map.h"
#include "fathom/import/suggest/rock_map.h"
#include "fathom/import/suggest/ros_map.h"
#include "fathom/import/suggest/tlog_map.h"

#include <string>

namespace fathom {

SuggestedMap SuggestMap(const Recording& recording,
                        const std::optional<Vehicle>& vehicle,
                        std::span<const MapWithWhen> own) {
  for (const MapWithWhen& map : own) {
    if (const auto suggested = map.For(recording.contents())) return *suggested;
  }
  const std::string& format = recording.contents().format;
  if (format == "dataflash") return ArdupilotMap(recording, vehicle);
  if (format == "ulog") return Px4Map(recording, vehicle);
  if (format == "tlog") return TlogMap(recording, vehicle);
  if (format == "ros1_bag" || format == "mcap" || format == "rosbag2") {
    return RosMap(recording, vehicle);
  }
  if (format == "alog") return MoosMap(recording.contents());
  if (format == "pocolog") return RockMap(recording.contents());
  if (const auto map = UvmsSimlabMap().For(recording.contents())) return *map;
  return MapByNames(recording.contents());
}

}  // namespace fathom
