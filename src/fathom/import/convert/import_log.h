// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/map/import_map.h"
#include "fathom/import/recording/recording.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// A log that was made from a recording, and what the way there left out or assumed. Its origin says
// what is odd about the stamps of the recording; the caller adds its names.
struct ImportedLog {
  Log log;
  std::vector<std::string> remarks;
};

// Turns a recording into a log as a map says: units into SI, axes into Fathom's, thruster commands
// into forces by the vehicle's tables; docs/import.md. `file`: where it comes from, for messages
// and for the log's name. `vehicle`: that of the map, if it names one.
//
// Throws InputError for whatever the recording does not hold, or does not fit the map.
ImportedLog ImportLog(const std::filesystem::path& file,
                      const Recording& recording,
                      const ImportMap& map,
                      const std::optional<Vehicle>& vehicle);

}  // namespace fathom
