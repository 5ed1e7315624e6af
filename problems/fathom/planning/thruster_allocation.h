// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What thrusters are to do.
struct AllocationTask {
  Dof dof = Dof::kSurge;
  // Of the supply [V]; NaN: that of the tables, where they hold one.
  double voltage = std::numeric_limits<double>::quiet_NaN();
  double thruster_force = PlanLimits::kNoLimit;  // greatest of each thruster, either way [N]
};

// How the thrusters of a vehicle give a force along one DOF: docs/plan.md (5).
struct ThrusterAllocation {
  std::vector<std::string> names;         // of the thrusters, in the order of the vehicle file
  std::vector<double> share;              // thrust of each for a force of 1 [1] or [1/m]
  std::vector<ValueRange> range;          // of each thrust; infinite: not known [N]
  std::vector<const ThrustTable*> table;  // of pulse widths, of each, in the Vehicle; else none
  double voltage = std::numeric_limits<double>::quiet_NaN();  // that the tables are read at [V]
  ValueRange reach;  // of the force along the DOF [N] or [N m]

  // Moments of roll and pitch that the thrusters cannot but give along, for a force of 1 [m] or
  // [1].
  double roll = 0.0, pitch = 0.0;

  // The greatest force that they can give both ways [N] or [N m].
  double ReachEachWay() const;

  // Of a force along the DOF, in the order of `names` [N].
  std::vector<double> ThrustsOf(double force) const;

  // The pulse widths that give them, to whole microseconds [us]. Empty unless each thruster has a
  // table of them.
  std::vector<int> PulsesOf(double force) const;
  bool HasPulses() const;
};

// The shortest thrusts that give a force along the DOF and none along the others. `name` stands for
// the vehicle file in messages; `vehicle` must outlive the result. Throws InputError where the
// thrusters give no such force, or the tables hold no such voltage.
ThrusterAllocation AllocateAlong(const AllocationTask& task,
                                 const Vehicle& vehicle,
                                 const std::string& name);

}  // namespace fathom
