// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/coupled_flags.h"

#include "fathom/base/input_error.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/tool/flag_values.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(dofs,
              "",
              "Several degrees of freedom as one coupled model: surge,sway,yaw. Instead of --dof.");
DEFINE_double(window, 20.0, "Of --dofs: the simulation begins anew after so long [s].");

namespace fathom {

namespace {

// A tool may lack the flag.
bool IsGiven(const char* flag) {
  gflags::CommandLineFlagInfo info;
  return gflags::GetCommandLineFlagInfo(flag, &info) && !info.is_default;
}

}  // namespace

bool IsCoupledAsked() { return !FLAGS_dofs.empty(); }

void RequireDofOrDofs(std::span<const Log> logs, std::optional<Dof> given) {
  if (given) return;
  for (const Log& log : logs) {
    if (log.dofs.size() < 2) continue;
    std::vector<std::string_view> names;
    for (const Dof dof : log.dofs) names.push_back(Name(dof));
    throw InputError(fmt::format(
        "--dof: is missing, and {} names {} DOFs; say which, or take them as one motion with "
        "--dofs={}.",
        FileOf(log, "log.yaml"),
        names.size(),
        fmt::join(names, ",")));
  }
}

void RequireFlagsOfOneKind(const std::vector<const char*>& of_one_dof) {
  if (!IsCoupledAsked()) {
    for (const char* flag : {"structure", "free", "window"}) {
      if (!IsGiven(flag)) continue;
      throw InputError(fmt::format(
          "--{}: goes with --dofs, expected none: without it a model of one DOF is made.", flag));
    }
    return;
  }
  for (const char* flag : of_one_dof) {
    if (!IsGiven(flag)) continue;
    throw InputError(
        fmt::format("--{}: goes with a model of one DOF, expected none beside --dofs.", flag));
  }
}

CoupledIdentificationOptions CoupledOptionsFromFlags() {
  CoupledIdentificationOptions options;
  for (const std::string& name : SplitAtCommas(FLAGS_dofs)) {
    options.dofs.push_back(ParseFlag("dofs", name, ParseDof));
  }
  std::sort(options.dofs.begin(), options.dofs.end());
  if (const auto twice = std::adjacent_find(options.dofs.begin(), options.dofs.end());
      twice != options.dofs.end()) {
    throw InputError(fmt::format("--dofs: names {} twice, expected each once.", Name(*twice)));
  }
  options.fit.window = FLAGS_window;
  if (const auto problems = options.fit.Problems(); !problems.empty()) {
    throw InputError(fmt::format("--{}.", problems.front()));
  }
  return options;
}

}  // namespace fathom
