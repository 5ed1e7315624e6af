// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/planning/thruster_allocation.h"
#include "fathom/planning/thruster_set.h"

#include <string>
#include <vector>

namespace fathom {

// How hard a plan drives the thrusters, and which do not say how much they can give. `vehicle`: the
// name of their file.
std::vector<std::string> UseOfThrusters(const PlannedThrusts& plan,
                                        const ThrusterSet& thrusters,
                                        const std::string& vehicle);

// The moments that the thrusters cannot but give beside a force along the DOF.
std::vector<std::string> MomentsToRight(Dof dof, const ThrusterAllocation& allocation);

}  // namespace fathom
