// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/dof_flag.h"

#include "fathom/base/input_error.h"
#include "fathom/tool/flag_values.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(dof,
              "",
              "surge, sway, heave, roll, pitch or yaw. Default: the only DOF of the log, or that "
              "of the model; a stream has none.");

namespace fathom {
namespace {

// Refuses a list, with what the tool can do about it: several DOFs as one motion, or a run each.
[[noreturn]] void RefuseList(const std::vector<std::string>& names) {
  std::vector<std::string> each_once;
  for (const std::string& name : names) {
    ParseFlag("dof", name, ParseDof);
    if (std::ranges::count(each_once, name) == 0) each_once.push_back(name);
  }
  const std::string refused = fmt::format("--dof: is '{}', expected one DOF", FLAGS_dof);
  if (each_once.size() == 1) {
    throw InputError(fmt::format("{}: --dof={}.", refused, each_once.front()));
  }
  gflags::CommandLineFlagInfo info;
  if (!gflags::GetCommandLineFlagInfo("dofs", &info)) {
    throw InputError(
        fmt::format("{}: a run for each, --dof={} first.", refused, each_once.front()));
  }
  throw InputError(
      fmt::format("{}. Several as one motion: --dofs={}.", refused, fmt::join(each_once, ",")));
}

}  // namespace

std::optional<Dof> DofFromFlag() {
  if (FLAGS_dof.empty()) return std::nullopt;
  const std::vector<std::string> names = SplitAtCommas(FLAGS_dof);
  if (names.size() > 1) RefuseList(names);
  return ParseFlag("dof", FLAGS_dof, ParseDof);
}

}  // namespace fathom
