// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <vector>

#include <Eigen/Core>

namespace fathom {

// The Fisher information about entries of the model that the velocities of the flown logs of a
// request hold, docs/plan.md (6): as a fit sees them, over windows of the model's horizon from
// measured starts that are free. `plan`: how large and how coloured the noise of a sample is. 0
// without logs. Throws InputError where the model's run over a log diverges, and for logs without a
// velocity of a modelled DOF.
Eigen::MatrixXd FlownInformation(const CoupledPlanRequest& request,
                                 const CoupledPlan& plan,
                                 const std::vector<FreeEntry>& entries);

}  // namespace fathom
