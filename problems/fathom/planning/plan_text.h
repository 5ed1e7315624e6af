// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/plan_request.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// What flown logs, of one DOF or several, are counted for.
inline constexpr const char* kFlownLogsCount =
    "What the logs of --log tell counts before, after, and after a sine. The values so far are "
    "still the model's: fit all logs together.";

// What to do and what comes of it, in one sentence or two.
std::string PlanSentence(const PlanRequest& request, const ExperimentPlan& plan);

// What the vehicle will do within the limits, and what was assumed: a sentence each.
std::vector<std::string> PlanComments(const PlanRequest& request, const ExperimentPlan& plan);

// 95 % intervals of each parameter, before and after.
Table PlannedParameterTable(const std::vector<PlannedParameter>& parameters);

// How well rivals are told apart; without rows where there are none.
Table PlannedSeparationTable(const std::vector<PlannedSeparation>& separations);

}  // namespace fathom
