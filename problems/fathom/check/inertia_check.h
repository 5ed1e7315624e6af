// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/check/finding.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>

namespace fathom {

// An inertia against the dry mass of the vehicle [kg]: a warning of code "inertia" if its 95 %
// interval lies below the mass, or above five times the mass. A vehicle cannot move with less than
// its mass, and the water that a body takes along adds once or twice that. The sentence names the
// units whose mistake would explain it. Nothing for an angular DOF.
std::optional<Finding> CheckInertia(Dof dof, double inertia, double std, double mass);

// The same of a model; nothing where the mass is not known.
std::optional<Finding> CheckInertia(const FittedModel& model, std::optional<double> mass);

}  // namespace fathom
