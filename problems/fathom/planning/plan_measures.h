// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/one_dof_judge.h"
#include "fathom/planning/plan_request.h"
#include "fathom/planning/stamp_noise.h"

#include <vector>

namespace fathom {

// What a command tells of the parameters, docs/plan.md (2). `noise`: at the stamps of the run.
CommandMeasure InformationMeasure(const PlanRequest& request, const StampNoise& noise);

// How well a command tells rivals apart, docs/plan.md (4).
CommandMeasure SeparationMeasure(const PlanRequest& request,
                                 std::vector<RivalModel> rivals,
                                 const StampNoise& noise);

}  // namespace fathom
