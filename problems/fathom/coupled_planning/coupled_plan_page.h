// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"
#include "fathom/report/page.h"

namespace fathom {

// The command of each axis, what the vehicle will do within its limits, and what will be known
// afterwards. Of a plan that is usable.
Page CoupledPlanPage(const CoupledPlanRequest& request, const CoupledPlan& plan);

}  // namespace fathom
