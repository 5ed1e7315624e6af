// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/thruster_files.h"

#include "fathom/planning/ardusub_script.h"

#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::string HeaderOfThrusters(const PlannedThrusts& plan) {
  std::string text = "t";
  for (std::size_t k = 1; k <= plan.thrust.front().size(); ++k) {
    text += fmt::format(",thruster_{}", k);
  }
  return text + "\n";
}

}  // namespace

std::string FormatPlannedThrusts(const PlannedThrusts& plan) {
  std::string text = HeaderOfThrusters(plan);
  for (std::size_t i = 0; i < plan.time.size(); ++i) {
    text += fmt::format("{},{}\n", plan.time[i], fmt::join(plan.thrust[i], ","));
  }
  return text;
}

std::string FormatPlannedPulses(const PlannedThrusts& plan, const ThrusterSet& thrusters) {
  std::string text = HeaderOfThrusters(plan);
  for (std::size_t i = 0; i < plan.time.size(); ++i) {
    text +=
        fmt::format("{},{}\n", plan.time[i], fmt::join(thrusters.PulsesOf(plan.thrust[i]), ","));
  }
  return text;
}

std::map<std::string, std::string> ThrusterFiles(std::string_view what,
                                                 const PlannedThrusts& plan,
                                                 const ThrusterSet& thrusters) {
  std::map<std::string, std::string> files = {{"thrusters.csv", FormatPlannedThrusts(plan)}};
  if (!thrusters.HasPulses()) return files;
  files["pulses.csv"] = FormatPlannedPulses(plan, thrusters);
  if (!HasArduSubScript(thrusters)) return files;
  files["plan.lua"] = FormatArduSubScript(what, plan, thrusters);
  return files;
}

}  // namespace fathom
