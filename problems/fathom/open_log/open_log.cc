// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/open_log/open_log.h"

#include "fathom/base/input_error.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/vehicle/files/thruster_command.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

void TakeDefaultVehicle(const std::filesystem::path& file, Log* log) {
  if (file.empty()) return;
  const bool is_of_it = log->vehicle.empty() || (!log->vehicle.ends_with(".yaml") &&
                                                 log->vehicle == ReadVehicleFile(file).name);
  if (is_of_it) log->vehicle = std::filesystem::absolute(file).string();
}

// Takes the mass, and turns a command of thrusters into forces.
void UseVehicleFile(Log* log) {
  const bool names_file = log->vehicle.ends_with(".yaml");
  const bool is_of_thrusters = log->command && IsOfThrusters(*log->command);
  if (is_of_thrusters && !names_file) {
    throw InputError(fmt::format(
        "{}: command.csv holds thrusters, but log.yaml names no vehicle file to turn them into "
        "forces. Add `vehicle: file.yaml`.",
        log->path.string()));
  }
  if (!names_file) return;
  const std::filesystem::path file = log->path / log->vehicle;
  std::error_code error;
  if (!is_of_thrusters && !std::filesystem::exists(file, error)) {
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
  if (!is_of_thrusters) return;
  log->thrusters =
      log->thruster_unit == "N" ? log->command : ThrustsFromSpeeds(*log->command, vehicle);
  log->command = ForcesOfThrusts(*log->thrusters, vehicle);
}

Log Completed(Log log, bool may_lack_motion) {
  UseVehicleFile(&log);
  if (!may_lack_motion && !log.velocity) TrackDetections(&log);
  return log;
}

}  // namespace

Log OpenLog(const std::filesystem::path& path,
            const ReadLogOptions& options,
            const std::filesystem::path& default_vehicle) {
  Log log = ReadLog(path, options);
  TakeDefaultVehicle(default_vehicle, &log);
  return Completed(std::move(log), options.may_lack_motion);
}

Log OpenLogText(const LogText& text, bool may_lack_motion) {
  return Completed(ParseLog(text), may_lack_motion);
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
