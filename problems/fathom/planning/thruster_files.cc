// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/thruster_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::string HeaderOfThrusters(const ThrusterAllocation& thrusters) {
  std::string text = "t";
  for (std::size_t k = 1; k <= thrusters.names.size(); ++k) text += fmt::format(",thruster_{}", k);
  return text + "\n";
}

}  // namespace

std::string FormatPlannedThrusts(const ExperimentPlan& plan, const ThrusterAllocation& thrusters) {
  std::string text = HeaderOfThrusters(thrusters);
  for (std::size_t i = 0; i < plan.command.time.size(); ++i) {
    text += fmt::format("{},{}\n",
                        plan.command.time[i],
                        fmt::join(thrusters.ThrustsOf(plan.command.value[i]), ","));
  }
  return text;
}

std::string FormatPlannedPulses(const ExperimentPlan& plan, const ThrusterAllocation& thrusters) {
  std::string text = HeaderOfThrusters(thrusters);
  for (std::size_t i = 0; i < plan.command.time.size(); ++i) {
    text += fmt::format(
        "{},{}\n", plan.command.time[i], fmt::join(thrusters.PulsesOf(plan.command.value[i]), ","));
  }
  return text;
}

}  // namespace fathom
