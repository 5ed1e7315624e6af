// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/suggest/found_channels.h"
#include "fathom/import/suggest/suggested_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A line of a map file, with its number in the file.
struct MapLine {
  int number = 0;
  std::string text;
};
using MapLines = std::vector<MapLine>;

// Whether the lines depend on what a recording holds: some stand between #if and #end, or are
// {thrusters}.
bool HasChoices(const MapLines& lines);

// The first of the conditions that asks for a channel that nobody looks for; empty: none does.
std::string UnknownCondition(const std::vector<std::string>& conditions,
                             const WantedChannels& wanted);

// Throws InputError for conditions as above, and for an #else or #end too many or too few.
void CheckLines(const std::string& file, const MapLines& lines, const WantedChannels& wanted);

// The text of a map file as one recording needs it, docs/import.md, "Maps with conditions".
// Conditions are "gps": that channel was found; "gps.fix": it has a field fix; "gps.alone": no
// other may be it; "vehicle": the recording has outputs for all its thrusters; "!gps": the
// opposite. {gps} is the name of the channel, {gps.type} its type, {gps.text} what the map says of
// it, {gps.others} how many others may be it; {thrusters} the lines of a vehicle's thrusters, which
// the channel `outputs` drives.
class FilledMap {
 public:
  // `vehicle` outlives this.
  FilledMap(FoundChannels found, const std::optional<Vehicle>& vehicle);

  // For {channel}: else lines that name it are left out.
  void SetChannel(const std::string& name) { channel_ = name; }

  // Whether all of the conditions hold.
  bool Meets(const std::vector<std::string>& conditions);

  std::string TextOf(const MapLines& lines);

  // Says last in the map, and in `why_not_ready`, that the vehicle has too many thrusters.
  void TellWhyNotDriven(SuggestedMap* map);

  // Says first in the map, and in `unknown`, what is not known of the motors.
  void TellUnknown(SuggestedMap* map);

 private:
  bool MeetsOne(std::string_view condition);
  bool IsDriven();  // by the outputs: all thrusters of a vehicle that is known
  std::string ThrusterText();
  std::optional<std::string> ValueOf(std::string_view place);
  std::string Filled(std::string_view line);

  FoundChannels found_;
  const std::optional<Vehicle>& vehicle_;
  std::optional<std::string> channel_;
};

}  // namespace fathom
