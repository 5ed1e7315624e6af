// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/held_command.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/planning/thruster_set.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <map>
#include <string>
#include <vector>

namespace fathom {

// What thrusters are to do.
struct AllocationTask {
  Dof dof = Dof::kSurge;
  ThrusterSupply supply = {};
  // Of thrusters by name, what one gives for a thrust of 1; 1 where it is not named.
  std::map<std::string, double> gain = {};
};

// How the thrusters of a vehicle give a force along one DOF: docs/plan.md (5).
struct ThrusterAllocation {
  ThrusterSet thrusters;
  std::vector<double> share;  // thrust of each for a force of 1 [1] or [1/m]
  ValueRange reach;           // of the force along the DOF [N] or [N m]

  // Moments of roll and pitch that the thrusters cannot but give along, for a force of 1 [m] or
  // [1].
  double roll = 0.0, pitch = 0.0;

  // The greatest force that they can give both ways [N] or [N m].
  double ReachEachWay() const;

  // Of a force along the DOF, in the order of the thrusters [N].
  std::vector<double> ThrustsOf(double force) const;
};

// Of each force of a command along the DOF.
PlannedThrusts ThrustsOf(const HeldCommand& command, const ThrusterAllocation& allocation);

// The shortest thrusts that give a force along the DOF and none along the others. `name` stands for
// the vehicle file in messages; `vehicle` must outlive the result. Throws InputError where the
// thrusters give no such force, or the tables hold no such voltage.
ThrusterAllocation AllocateAlong(const AllocationTask& task,
                                 const Vehicle& vehicle,
                                 const std::string& name);

}  // namespace fathom
