// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/open_log.h"

#include "fathom/base/input_error.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <string>
#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

bool HasThrusterSpeeds(const Log& log) {
  return log.command && !log.command->columns.empty() &&
         log.command->columns[0].starts_with("thruster");
}

// Takes the mass, and turns thruster speeds into forces.
void UseVehicleFile(Log* log) {
  const bool names_file = log->vehicle.ends_with(".yaml");
  if (HasThrusterSpeeds(*log) && !names_file) {
    throw InputError(fmt::format(
        "{}: command.csv holds thruster speeds, but log.yaml names no vehicle file to turn them "
        "into forces. Add `vehicle: file.yaml`.",
        log->path.string()));
  }
  if (!names_file) return;
  const std::filesystem::path file = log->path / log->vehicle;
  std::error_code error;
  if (!HasThrusterSpeeds(*log) && !std::filesystem::exists(file, error)) {
    log->remarks.push_back(
        {RemarkKind::kGeneral,
         fmt::format("{} is missing, so that no inertia is held against the vehicle's mass.",
                     file.lexically_normal().string())});
    return;
  }
  const Vehicle vehicle = ReadVehicleFile(file);
  if (!log->mass) log->mass = vehicle.mass;
  if (!log->mass) {
    log->remarks.push_back({RemarkKind::kGeneral,
                            fmt::format("{} has no mass, so that no inertia is held against it.",
                                        file.lexically_normal().string())});
  }
  if (HasThrusterSpeeds(*log)) log->command = ForcesFromThrusters(*log->command, vehicle);
}

}  // namespace

Log OpenLog(const std::filesystem::path& path, const ReadLogOptions& options) {
  Log log = ReadLog(path, options);
  UseVehicleFile(&log);
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
