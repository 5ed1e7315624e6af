// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/suggest_map.h"

#include "fathom/import/suggest/map_by_names.h"

namespace fathom {

SuggestedMap SuggestMap(const Recording& recording,
                        const std::optional<Vehicle>& vehicle,
                        std::span<const MapWithWhen> own) {
  for (const auto& maps : {own, KnownMaps()}) {
    for (const MapWithWhen& map : maps) {
      if (const auto suggested = map.For(recording, vehicle)) return *suggested;
    }
  }
  return MapByNames(recording.contents());
}

std::string WhatIsLookedFor(std::string_view format) {
  for (const MapWithWhen& map : KnownMaps()) {
    if (!map.LooksFor(format).empty()) return std::string(map.LooksFor(format));
  }
  return "fields that are called as a command (tau_surge, force, thrust), a velocity (u, vx, "
         "speed, r, yaw_rate) or a pose (x, y and yaw or qw) often is, in a unit of that kind or "
         "in "
         "none";
}

}  // namespace fathom
