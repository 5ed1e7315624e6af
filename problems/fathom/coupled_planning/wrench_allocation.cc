// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/wrench_allocation.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNoMoment = 1e-9;  // for a force of 1 [m] or [1]

// What comes along in roll and pitch must not be commanded: the other DOFs AllocateAlong() looks
// after.
void RequireAlone(Dof dof,
                  const ThrusterAllocation& allocation,
                  const std::vector<Dof>& dofs,
                  const std::string& name) {
  for (const auto& [moment, other] :
       {std::pair{allocation.roll, Dof::kRoll}, std::pair{allocation.pitch, Dof::kPitch}}) {
    const bool is_commanded = std::find(dofs.begin(), dofs.end(), other) != dofs.end();
    if (!is_commanded || std::abs(moment) <= kNoMoment) continue;
    throw InputError(fmt::format(
        "{}: its thrusters give {} {:.3g} N m for each {} of {}, expected DOFs that they drive one "
        "without the other: leave one out with --dofs.",
        name,
        Name(other),
        moment,
        ForceUnit(dof),
        Name(dof)));
  }
}

}  // namespace

std::vector<double> WrenchAllocation::ThrustsOf(const Vector6& wrench) const {
  std::vector<double> thrusts(thrusters().names.size(), 0.0);
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    for (std::size_t k = 0; k < thrusts.size(); ++k) {
      thrusts[k] += along[i].share[k] * wrench[Index(dofs[i])];
    }
  }
  return thrusters().WithoutRounding(std::move(thrusts));
}

bool WrenchAllocation::Gives(const Vector6& wrench) const {
  return thrusters().Gives(ThrustsOf(wrench));
}

bool WrenchAllocation::Gives(const CoupledCommand& command) const {
  return std::all_of(command.force.begin(), command.force.end(), [&](const Vector6& wrench) {
    return Gives(wrench);
  });
}

PlannedThrusts ThrustsOf(const CoupledCommand& command, const WrenchAllocation& allocation) {
  PlannedThrusts thrusts = {command.time, {}};
  for (const Vector6& wrench : command.force) {
    thrusts.thrust.push_back(allocation.ThrustsOf(wrench));
  }
  return thrusts;
}

WrenchAllocation AllocateWrench(const std::vector<Dof>& dofs,
                                const ThrusterSupply& supply,
                                const std::map<std::string, double>& gain,
                                const Vehicle& vehicle,
                                const std::string& name) {
  WrenchAllocation allocation = {dofs, {}};
  for (const Dof dof : dofs) {
    allocation.along.push_back(AllocateAlong({dof, supply, gain}, vehicle, name));
    RequireAlone(dof, allocation.along.back(), dofs, name);
  }
  return allocation;
}

}  // namespace fathom
