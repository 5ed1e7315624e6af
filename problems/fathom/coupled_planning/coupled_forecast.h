// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"
#include "fathom/coupled_planning/wrench_judge.h"
#include "fathom/coupled_planning/wrench_run.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Entries that a wrench can tell, and what is known of them.
struct ToldEntries {
  std::vector<FreeEntry> entries;
  Eigen::MatrixXd covariance;
  Eigen::MatrixXd flown;  // FlownInformation() of them
};

// What will be known of the entries after the command of the plan, and after its sine, the flown
// logs counted along. Infinite: these leave the entry open. The middle of what `models` say, of
// which the first is the fit's: one that runs straight ahead alone would make a yaw that nothing
// holds tell more than it does.
void ForecastEntries(std::span<const CoupledModel> models,
                     const ToldEntries& told,
                     const WrenchMeasurement& measurement,
                     CoupledPlan* plan);

// How well the command of the plan and its sine tell rivals apart: the middle of what `models` say.
void ForecastSeparations(std::span<const CoupledModel> models,
                         const WrenchQuestion& question,
                         CoupledPlan* plan);

// What the model will do under the command of the plan, and how many of `others` break a limit.
// False if the model diverges.
bool ForecastMotion(const CoupledPlanRequest& request,
                    std::span<const CoupledModel> others,
                    CoupledPlan* plan);

}  // namespace fathom
