// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A map that says itself which recordings it is for, docs/import.md, "Maps of a lab":
//
//   when: {format: mcap, channels: [/rov/wrench], fields: [force.x, force.y], ready: true}
//
// Every condition that is named must hold: the format, channels that are all there, fields that
// one channel has all of. In a map with `fields` a line with "{channel}" names that channel; it is
// left out where the recording has no other. `find` looks for channels by their types; lines
// between #if and #end hold where these are there. That of an autopilot takes its outputs as the
// thrusters of a vehicle.
class MapWithWhen {
 public:
  // `name` stands for the file in messages. Throws InputError for what is no such map.
  MapWithWhen(const std::string& name, const std::string& text);

  // The map, without `when`, as that recording needs it; nothing for another one. It is ready where
  // `when` says so.
  std::optional<SuggestedMap> For(const Recording& recording,
                                  const std::optional<Vehicle>& vehicle) const;

  // What it looks for in recordings of that format, a clause; empty: it does not say, or is not
  // for them.
  std::string_view LooksFor(std::string_view format) const;

 private:
  struct When;
  std::shared_ptr<const When> when_;
};

// Those of a folder's *.yaml files, by name. Throws InputError as above, and where there is none.
std::vector<MapWithWhen> ReadMapsWithWhen(const std::filesystem::path& folder);

// Those that come with Fathom, data/maps.
std::span<const MapWithWhen> KnownMaps();

}  // namespace fathom
