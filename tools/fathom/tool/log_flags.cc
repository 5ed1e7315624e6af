// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/log_flags.h"

#include "fathom/base/input_error.h"
#include "fathom/base/shell_word.h"
#include "fathom/log/hold_out.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/open_log/open_log.h"
#include "fathom/tool/correct_flag.h"
#include "fathom/tool/default_vehicle_flag.h"
#include "fathom/tool/flag_values.h"
#include "fathom/tool/held_out_flag.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <span>
#include <system_error>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(log,
              "",
              "Log folder, or a single CSV with columns t, tau, v, which does not say its DOF.");
DEFINE_string(velocity, "", "Read this CSV instead of the log's velocity.csv.");

namespace fathom {
namespace {

// To stderr, with the log's path where it is one of several.
void PrintRemark(const Log& log, const Remark& remark) {
  const bool is_of_several = PathsInValues(FLAGS_log).size() > 1;
  const std::string place = is_of_several ? log.path.string() + ": " : "";
  PrintText(stderr, place + remark.text + "\n");
}

// From the remark `first` on.
void PrintRemarks(const Log& log, std::size_t first) {
  for (std::size_t i = first; i < log.remarks.size(); ++i) PrintRemark(log, log.remarks[i]);
}

bool IsHeldOut(const Log& log, double t) {
  return std::ranges::any_of(log.held_out,
                             [&](const TimeInterval& interval) { return interval.Contains(t); });
}

bool LeavesNothing(const Log& log) {
  for (const auto* stream : {&log.velocity, &log.pose, &log.detections}) {
    if (!*stream) continue;
    if (!std::ranges::all_of((*stream)->time, [&](double t) { return IsHeldOut(log, t); })) {
      return false;
    }
  }
  return true;
}

std::vector<Log> OpenLogs(std::optional<Dof> dof, bool may_lack_motion, bool may_lack_command) {
  const std::vector<std::string> paths = LogPathsFromFlags();
  if (!FLAGS_velocity.empty() && paths.size() > 1) {
    throw InputError("--velocity: belongs to one log, expected a single --log with it.");
  }
  ReadLogOptions options;
  options.dof = dof;
  options.velocity = FLAGS_velocity;
  options.held_out = HeldOutFromFlag();
  options.corrections = CorrectionsFromFlag();
  options.may_lack_motion = may_lack_motion;
  options.may_lack_command = may_lack_command;
  std::vector<Log> logs;
  for (const std::string& path : paths) {
    logs.push_back(OpenLog(path, options, DefaultVehicleFromFlag()));
  }
  RequireDifferentData(logs);
  RequireHeldOutInside(options.held_out, logs);
  if (!may_lack_motion) RequireTrainingData(logs);
  return logs;
}

}  // namespace

void RequireTrainingData(std::span<const Log> logs) {
  if (HeldOutFromFlag().empty() || !std::ranges::all_of(logs, LeavesNothing)) return;
  throw InputError("--held_out: takes all of the data, expected some to train on.");
}

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

std::vector<std::string> LogPathsFromFlags() {
  namespace fs = std::filesystem;
  const std::vector<std::string> paths = PathsInValues(FLAGS_log);
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

std::string GivenFlags(std::initializer_list<const char*> names) {
  std::string text;
  for (const char* const name : names) {
    std::string value;
    gflags::GetCommandLineOption(name, &value);
    if (!value.empty()) text += fmt::format(" --{}={}", name, ShellWord(value));
  }
  return text;
}

std::vector<Log> ReadLogsFromFlags(std::optional<Dof> dof,
                                   bool may_lack_motion,
                                   bool may_lack_command) {
  std::vector<Log> logs = OpenLogs(dof, may_lack_motion, may_lack_command);
  for (const Log& log : logs) PrintRemarks(log, 0);
  return logs;
}

std::vector<Log> ReadCoupledLogsFromFlags(bool may_lack_motion) {
  std::vector<Log> logs = OpenLogs({}, may_lack_motion, false);
  for (const Log& log : logs) {
    for (const Remark& remark : log.remarks) {
      if (remark.kind != RemarkKind::kSurfaces) PrintRemark(log, remark);
    }
  }
  return logs;
}

void AddCameraSource(Log* log) {
  const size_t num_printed = log->remarks.size();
  TrackDetections(log);
  PrintRemarks(*log, num_printed);
}

void AddCameraSourceIfUsable(Log* log) {
  const size_t num_printed = log->remarks.size();
  TrackDetectionsIfUsable(log);
  PrintRemarks(*log, num_printed);
}

}  // namespace fathom
