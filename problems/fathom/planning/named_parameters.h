// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/vehicle/fitted_model.h"

#include <vector>

namespace fathom {

// The parameters of a model in the order of its covariance: names, units and values so far.
std::vector<PlannedParameter> NamedParameters(const FittedModel& model);

}  // namespace fathom
