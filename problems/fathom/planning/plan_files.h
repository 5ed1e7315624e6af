// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/plan_request.h"

#include <string>

namespace fathom {

// plan.json, schema "fathom-plan-1"; docs/file_formats.md.
std::string FormatPlan(const PlanRequest& request, const ExperimentPlan& plan);

// command.csv as a log's, with a last row without force.
std::string FormatPlannedCommand(Dof dof, const ExperimentPlan& plan);

// An experiment file for fathom_synthesize that plays the command.csv beside it.
std::string FormatPlannedExperiment(const PlanRequest& request, const ExperimentPlan& plan);

}  // namespace fathom
