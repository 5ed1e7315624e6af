// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/planning/thruster_allocation.h"

#include <string>

namespace fathom {

// A force that a limits file allows.
struct ForceLimit {
  std::string file;    // its name, for messages
  std::string key;     // "force", "force.yaw"
  double force = 0.0;  // greatest each way [N] or [N m]
};

// Throws InputError if a limits file says how much of a thruster may be taken, where no vehicle is
// given that has some.
void RequireNoThrusterForce(const std::string& limits_name, double thruster_force);

// Throws InputError if the thrusters push along the DOF one way only. `vehicle`: the name of their
// file.
void RequireBothWays(Dof dof, const ThrusterAllocation& allocation, const std::string& vehicle);

// Throws InputError if a limit is more than the thrusters give along the DOF.
void RequireWithinReach(const ForceLimit& limit,
                        Dof dof,
                        const ThrusterAllocation& allocation,
                        const std::string& vehicle);

}  // namespace fathom
