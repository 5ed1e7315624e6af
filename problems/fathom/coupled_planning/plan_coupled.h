// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"

namespace fathom {

// The wrench that tells most of a coupled model's entries, within the limits; docs/plan.md.
//
// Throws InputError for a model whose covariance or noise is not known, for commands in another
// unit than N and N m, and for a DOF to command that is not modelled or has no force in the limits.
// Where no command keeps the limits, the plan says so.
CoupledPlan PlanCoupledExperiment(const CoupledPlanRequest& request);

}  // namespace fathom
