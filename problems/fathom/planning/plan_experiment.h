// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/plan_request.h"

namespace fathom {

// The experiment that tells most of what is open, within the limits; docs/plan.md.
//
// Throws InputError for a model whose covariance or noise is not known, for effects that need
// another DOF, and for commands in another unit than N or N m. Where no command keeps the limits,
// the plan says so.
ExperimentPlan PlanExperiment(const PlanRequest& request);

}  // namespace fathom
