// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/plan_request.h"
#include "fathom/report/page.h"

namespace fathom {

// The command, what the vehicle will do within its limits, and what will be known afterwards. Of a
// plan that is usable.
Page PlanPage(const PlanRequest& request, const ExperimentPlan& plan);

}  // namespace fathom
