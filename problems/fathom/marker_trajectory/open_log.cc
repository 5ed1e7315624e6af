// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/open_log.h"

#include "fathom/base/input_error.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

void TurnThrusterSpeedsIntoForces(Log* log) {
  const bool has_thrusters = log->command && !log->command->columns.empty() &&
                             log->command->columns[0].starts_with("thruster");
  if (!has_thrusters) return;
  if (!log->vehicle.ends_with(".yaml")) {
    throw InputError(fmt::format(
        "{}: command.csv holds thruster speeds, but log.yaml names no vehicle file to turn them "
        "into forces. Add `vehicle: file.yaml`.",
        log->path.string()));
  }
  log->command = ForcesFromThrusters(*log->command, ReadVehicleFile(log->path / log->vehicle));
}

}  // namespace

Log OpenLog(const std::filesystem::path& path, const ReadLogOptions& options) {
  Log log = ReadLog(path, options);
  TurnThrusterSpeedsIntoForces(&log);
  if (!options.may_lack_motion && !log.velocity) TrackDetections(&log);
  return log;
}

void TrackDetectionsIfUsable(Log* log) {
  try {
    TrackDetections(log);
  } catch (const InputError& error) {
    log->remarks.push_back(
        {RemarkKind::kGeneral, std::string("The camera is not used: ") + error.what()});
  }
}

}  // namespace fathom
