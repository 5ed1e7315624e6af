// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/log_flags.h"

#include "fathom/base/input_error.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/log/read_log.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(log,
              "",
              "Log folder, or a single CSV with columns t, tau, v (then --dof is needed).");
DEFINE_string(velocity, "", "Read this CSV instead of the log's velocity.csv.");

namespace fathom {
namespace {

void RequireDifferentData(const std::vector<Log>& logs) {
  if (logs.size() < 2) return;
  std::map<std::string, std::string> path_of;
  for (const Log& log : logs) {
    const auto [other, is_new] = path_of.try_emplace(FingerprintOf(log), log.path.string());
    if (is_new) continue;
    throw InputError(fmt::format("--log: {} and {} hold the same data, expected each log once.",
                                 other->second,
                                 log.path.string()));
  }
}

}  // namespace

std::vector<std::string> SplitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  size_t begin = 0;
  while (true) {
    const size_t comma = text.find(',', begin);
    parts.push_back(text.substr(begin, comma - begin));
    if (comma == std::string::npos) return parts;
    begin = comma + 1;
  }
}

std::vector<std::string> LogPathsFromFlags() {
  namespace fs = std::filesystem;
  std::vector<std::string> paths = SplitAtCommas(FLAGS_log);
  std::vector<fs::path> places;
  for (const std::string& path : paths) {
    std::error_code error;
    fs::path place = fs::canonical(path, error);
    if (error) continue;  // the reader says what is wrong with it
    if (std::find(places.begin(), places.end(), place) != places.end()) {
      throw InputError(fmt::format("--log: names {} twice, expected each log once.", path));
    }
    places.push_back(std::move(place));
  }
  return paths;
}

std::vector<std::string> InputsFromFlags() {
  std::vector<std::string> inputs = LogPathsFromFlags();
  if (!FLAGS_velocity.empty()) inputs.push_back(FLAGS_velocity);
  return inputs;
}

Log ReadLogFromFlags(const std::string& path, std::optional<Dof> dof, bool may_lack_motion) {
  ReadLogOptions options;
  options.dof = dof;
  options.velocity = FLAGS_velocity;
  options.may_lack_motion = may_lack_motion;
  Log log = ReadLog(path, options);
  const bool has_thrusters = log.command && !log.command->columns.empty() &&
                             log.command->columns[0].starts_with("thruster");
  if (has_thrusters) {
    if (!log.vehicle.ends_with(".yaml")) {
      throw InputError(fmt::format(
          "{}: command.csv holds thruster speeds, but log.yaml names no vehicle file to turn them "
          "into forces. Add `vehicle: file.yaml`.",
          path));
    }
    log.command = ForcesFromThrusters(*log.command, ReadVehicleFile(log.path / log.vehicle));
  }
  for (const Remark& remark : log.remarks) std::fprintf(stderr, "%s\n", remark.text.c_str());
  if (!may_lack_motion && !log.velocity) AddCameraSource(&log);
  return log;
}

std::vector<Log> ReadLogsFromFlags(std::optional<Dof> dof, bool may_lack_motion) {
  const std::vector<std::string> paths = LogPathsFromFlags();
  if (!FLAGS_velocity.empty() && paths.size() > 1) {
    throw InputError("--velocity: belongs to one log, expected a single --log with it.");
  }
  std::vector<Log> logs;
  for (const std::string& path : paths) {
    logs.push_back(ReadLogFromFlags(path, dof, may_lack_motion));
  }
  RequireDifferentData(logs);
  return logs;
}

void AddCameraSource(Log* log) {
  const size_t num_printed = log->remarks.size();
  TrackDetections(log);
  for (size_t i = num_printed; i < log->remarks.size(); ++i) {
    std::fprintf(stderr, "%s\n", log->remarks[i].text.c_str());
  }
}

void AddCameraSourceIfUsable(Log* log) {
  try {
    AddCameraSource(log);
  } catch (const InputError& error) {
    log->remarks.push_back(
        {RemarkKind::kGeneral, std::string("The camera is not used: ") + error.what()});
    std::fprintf(stderr, "%s\n", log->remarks.back().text.c_str());
  }
}

}  // namespace fathom
