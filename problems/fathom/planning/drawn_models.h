// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/random_stream.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Models that the log allows: parameters normal with the fit's covariance, drawn anew where they
// leave what is physical. Throws InputError, beginning with `name`, if the covariance is not known
// or nearly no draw is physical.
std::vector<ExtendedModel> DrawModels(const FittedModel& fitted,
                                      int count,
                                      const std::string& name,
                                      RandomStream& random);

// The factor of a covariance, CovarianceFactor(). Throws InputError, beginning with `name`, if it
// is not known.
Eigen::MatrixXd KnownFactor(const Eigen::MatrixXd& covariance, const std::string& name);

// Throws InputError, beginning with `name`: nearly no draw is physical.
[[noreturn]] void RefuseDraws(const std::string& name);

}  // namespace fathom
