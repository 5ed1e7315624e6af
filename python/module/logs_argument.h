// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <optional>
#include <string>
#include <vector>

#include "module/opened_log.h"
#include <pybind11/pybind11.h>

namespace fathom {

struct OpenLogArguments {
  std::optional<Dof> dof = {};
  std::string velocity = {};
  std::string held_out = {};
  std::vector<TimeInterval> held_out_times = {};
  std::vector<Correction> corrections = {};
  std::string corrections_by = {};
  bool is_tracked = true;  // detections become poses where the log has no motion but them
};

// Opens a path as every tool does. A log may lack the command or the motion: who needs them says
// so.
OpenedLog OpenPath(const std::string& path, const OpenLogArguments& arguments);

// A Log, a path, or a list of either. Paths are opened with `dof`. Throws InputError if there is
// none, or if two hold the same data.
std::vector<OpenedLog> LogsOfArgument(const pybind11::object& argument, std::optional<Dof> dof);

// The same of logs whose corners are refined: their detections are not tracked on the way in.
std::vector<OpenedLog> FilmedLogsOfArgument(const pybind11::object& argument,
                                            std::optional<Dof> dof);

std::vector<Log> PlainLogs(const std::vector<OpenedLog>& opened);

// Throws InputError if a log measures no motion at all.
void RequireMotion(const std::vector<OpenedLog>& opened);

// "a,b", as a model's provenance has them.
std::string PlacesOf(const std::vector<OpenedLog>& opened);

// The text of a str or os.PathLike; throws TypeError for others.
std::string PathOf(const pybind11::handle& path);

}  // namespace fathom
