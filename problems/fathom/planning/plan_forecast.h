// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/plan_request.h"
#include "fathom/planning/stamp_noise.h"

#include <span>
#include <vector>

namespace fathom {

// What is to come of plan->command, each into the plan. `noise`: at the stamps.

// The intervals of the parameters: medians over `models`, which the log so far allows.
void ForecastParameters(const PlanRequest& request,
                        std::span<const ExtendedModel> models,
                        std::span<const double> stamps,
                        const StampNoise& noise,
                        ExperimentPlan* plan);

// How far rivals lie apart, and which of them pass a limit.
void ForecastSeparations(const PlanRequest& request,
                         const std::vector<RivalModel>& rivals,
                         std::span<const double> stamps,
                         const StampNoise& noise,
                         ExperimentPlan* plan);

// The motion with its bands and ranges over `models`, and how many of these break the limits.
// False if the model itself diverges.
bool ForecastMotion(const PlanRequest& request,
                    std::span<const ExtendedModel> models,
                    std::span<const double> stamps,
                    ExperimentPlan* plan);

}  // namespace fathom
