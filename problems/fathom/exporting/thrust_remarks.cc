// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/thrust_remarks.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {
namespace {

bool HasThruster(const ExportTarget& target, const std::string& name) {
  if (!target.vehicle) return false;
  const auto& thrusters = target.vehicle->thrusters;
  return std::any_of(
      thrusters.begin(), thrusters.end(), [&](const auto& t) { return t.name == name; });
}

}  // namespace

void AddUnitRemark(const ExportModel& model, std::vector<std::string>* remarks) {
  if (model.force_unit == "N") return;
  remarks->push_back(fmt::format(
      "Commands are in {}, not in newtons: give tau in that unit. Only ratios of the numbers have "
      "a meaning.",
      model.force_unit));
}

void AddGainRemarks(const ExportModel& model,
                    const ExportTarget& target,
                    std::vector<std::string>* remarks) {
  for (const auto& [thruster, gain] : model.model.thrust_gain) {
    if (HasThruster(target, thruster)) continue;
    remarks->push_back(
        fmt::format("The gain {:.4g} of the thruster {} is left out: multiply its thrust by it "
                    "before tau is summed, or give the vehicle file that has it.",
                    gain,
                    thruster));
  }
}

}  // namespace fathom
