// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"

#include <string>

namespace fathom {

// plan.json, schema "fathom-plan-2"; docs/file_formats.md.
std::string FormatCoupledPlan(const CoupledPlanRequest& request, const CoupledPlan& plan);

// command.csv as a log's: t and a column of each axis, with a last row without force.
std::string FormatWrenchCommand(const CoupledPlan& plan);

// An experiment file for fathom_synthesize that plays the command.csv beside it.
std::string FormatWrenchExperiment(const CoupledPlanRequest& request, const CoupledPlan& plan);

}  // namespace fathom
