// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// The commanded DOFs: "surge, sway, yaw".
std::string NamesOfAxes(const CoupledPlan& plan);

// What to do and what comes of it, in one sentence or two; of rivals, one for each pair.
std::string CoupledPlanSentence(const CoupledPlan& plan);

// What the vehicle will do within the limits, and what was assumed: a sentence each.
std::vector<std::string> CoupledPlanComments(const CoupledPlanRequest& request,
                                             const CoupledPlan& plan);

// 95 % intervals of each entry, before and after.
Table PlannedEntryTable(const CoupledPlan& plan);

// How well rivals are told apart; without rows where there are none.
Table CoupledSeparationTable(const CoupledPlan& plan);

}  // namespace fathom
