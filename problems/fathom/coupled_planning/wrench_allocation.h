// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/planning/thruster_allocation.h"
#include "fathom/planning/thruster_set.h"
#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <map>
#include <string>
#include <vector>

namespace fathom {

// How the thrusters of a vehicle give a wrench: the sum of the shortest thrusts along each DOF,
// docs/plan.md (5), which are the shortest of the wrench.
struct WrenchAllocation {
  std::vector<Dof> dofs;                  // that are commanded
  std::vector<ThrusterAllocation> along;  // each of them

  const ThrusterSet& thrusters() const { return along.front().thrusters; }

  // Of the commanded DOFs' part of a wrench [N], [N m], in the order of the thrusters [N].
  std::vector<double> ThrustsOf(const Vector6& wrench) const;

  // Whether each thruster is within its range, under one wrench or all of a command's.
  bool Gives(const Vector6& wrench) const;
  bool Gives(const CoupledCommand& command) const;
};

// Of each wrench of a command.
PlannedThrusts ThrustsOf(const CoupledCommand& command, const WrenchAllocation& allocation);

// `dofs`: at least one. `gain`: of thrusters by name, as AllocationTask has it. `name` stands for
// the vehicle file in messages; `vehicle` must outlive the result. Throws InputError as
// AllocateAlong(), and where the thrusters cannot drive one of these DOFs without another.
WrenchAllocation AllocateWrench(const std::vector<Dof>& dofs,
                                const ThrusterSupply& supply,
                                const std::map<std::string, double>& gain,
                                const Vehicle& vehicle,
                                const std::string& name);

}  // namespace fathom
