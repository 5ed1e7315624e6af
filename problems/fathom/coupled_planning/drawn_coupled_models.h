// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/random_stream.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <string>
#include <vector>

namespace fathom {

// Models that the log allows: entries normal with the fit's covariance, drawn anew where they leave
// what a body can be: inertia positive definite, damping passive where the fit's is, no lag below
// 0 s. How far two clocks differ stays. Throws
// InputError, beginning with `name`, if the covariance is not known or nearly no draw is physical.
std::vector<CoupledModel> DrawCoupledModels(const FittedCoupledModel& fitted,
                                            int count,
                                            const std::string& name,
                                            RandomStream& random);

}  // namespace fathom
