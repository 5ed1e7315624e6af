// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/logs_argument.h"

#include "fathom/base/files/exists.h"
#include "fathom/base/input_error.h"
#include "fathom/log/hold_out.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/open_log/open_log.h"

#include <map>
#include <utility>

#include <fmt/format.h>

namespace fathom {

namespace py = pybind11;

namespace {

OpenedLog OneLog(const py::handle& argument, const OpenLogArguments& arguments) {
  if (py::isinstance<OpenedLog>(argument)) return argument.cast<const OpenedLog&>();
  const std::string path = PathOf(argument);
  const py::gil_scoped_release release;
  return OpenPath(path, arguments);
}

void RequireOtherData(const std::vector<OpenedLog>& logs) {
  if (logs.size() < 2) return;
  std::map<std::string, std::string> place_of;
  for (const OpenedLog& log : logs) {
    const auto [other, is_new] = place_of.try_emplace(FingerprintOf(log.log), log.place);
    if (is_new) continue;
    throw InputError(fmt::format(
        "log: {} and {} hold the same data, expected each log once.", other->second, log.place));
  }
}

std::vector<OpenedLog> EachLog(const py::object& argument, const OpenLogArguments& arguments) {
  std::vector<OpenedLog> logs;
  if (py::isinstance<py::list>(argument) || py::isinstance<py::tuple>(argument)) {
    for (const py::handle& one : argument) logs.push_back(OneLog(one, arguments));
  } else {
    logs.push_back(OneLog(argument, arguments));
  }
  if (logs.empty()) throw InputError("log: is an empty list, expected a log or several.");
  return logs;
}

}  // namespace

OpenedLog OpenPath(const std::string& path, const OpenLogArguments& arguments) {
  ReadLogOptions options;
  options.dof = arguments.dof;
  options.velocity = arguments.velocity;
  options.held_out = arguments.held_out_times;
  options.corrections = arguments.corrections;
  options.corrections_by = arguments.corrections_by;
  options.may_lack_motion = true;
  options.may_lack_command = true;
  Log log = OpenLog(path, options);
  RequireHeldOutInside(options.held_out, {&log, 1});
  // A motion in detections alone becomes poses, where the calibration serves.
  if (arguments.is_tracked && !log.velocity && !log.pose && log.detections) {
    TrackDetectionsIfUsable(&log);
  }
  return {std::move(log), path, arguments.velocity, arguments.held_out, false};
}

std::vector<OpenedLog> LogsOfArgument(const py::object& argument, std::optional<Dof> dof) {
  std::vector<OpenedLog> logs = EachLog(argument, {.dof = dof});
  RequireOtherData(logs);
  return logs;
}

std::vector<OpenedLog> FilmedLogsOfArgument(const py::object& argument, std::optional<Dof> dof) {
  std::vector<OpenedLog> logs = EachLog(argument, {.dof = dof, .is_tracked = false});
  for (OpenedLog& opened : logs) {
    Log& log = opened.log;
    if (opened.is_of_arrays) {
      throw InputError("log: is of arrays, expected a log folder with detections.csv.");
    }
    // A Log that was tracked when it was opened.
    if (log.pose && !Exists(log.path / "pose.csv")) log.pose.reset();
  }
  RequireOtherData(logs);
  return logs;
}

std::vector<Log> PlainLogs(const std::vector<OpenedLog>& opened) {
  std::vector<Log> logs;
  for (const OpenedLog& one : opened) logs.push_back(one.log);
  return logs;
}

void RequireMotion(const std::vector<OpenedLog>& opened) {
  for (const OpenedLog& one : opened) {
    if (one.log.velocity || one.log.pose || one.log.detections) continue;
    throw InputError(
        fmt::format("{}: holds neither velocities nor poses nor detections, expected the "
                    "vehicle's motion in one of them.",
                    one.place));
  }
}

std::string PlacesOf(const std::vector<OpenedLog>& opened) {
  std::string places;
  for (const OpenedLog& one : opened) places += (places.empty() ? "" : ",") + one.place;
  return places;
}

std::string PathOf(const py::handle& path) {
  const auto text = py::module_::import("os").attr("fsencode")(path).cast<std::string>();
  if (text.find('\0') != std::string::npos) throw InputError("a path holds a null character.");
  return text;
}

}  // namespace fathom
