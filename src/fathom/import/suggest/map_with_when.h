// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// A map that says itself which recordings it is for, docs/import.md, "Maps of a lab":
//
//   when: {format: mcap, channels: [/rov/wrench], fields: [force.x, force.y], ready: true}
//
// Every condition that is named must hold: the format, channels that are all there, fields that
// one channel has all of. In a map with `fields` a line with "{channel}" names that channel; it is
// left out where the recording has no other.
class MapWithWhen {
 public:
  // `name` stands for the file in messages. Throws InputError for what is no such map.
  MapWithWhen(const std::string& name, std::string text);

  // The map, without `when`, as that recording needs it; nothing for another one. It is ready where
  // `when` says so.
  std::optional<SuggestedMap> For(const Contents& contents) const;

 private:
  std::string TextFor(const std::string& channel, bool is_only_channel) const;

  std::string text_;
  std::vector<std::string> formats_, channels_, fields_;
  bool is_ready_ = false;
};

// Those of a folder's *.yaml files, by name. Throws InputError as above, and where there is none.
std::vector<MapWithWhen> ReadMapsWithWhen(const std::filesystem::path& folder);

// The one that comes with Fathom, of a table: data/maps.
const MapWithWhen& UvmsSimlabMap();

}  // namespace fathom
