// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/random_stream.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <functional>
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

// Steps from what was fitted, drawn with its covariance. `take` gets one and says whether it leads
// to a model that is physical: it gets another while it does not, `most_trials` at most, and this
// until `count` are taken. Throws InputError as DrawModels() does.
struct DrawnSteps {
  const Eigen::MatrixXd& covariance;
  const std::string& name;
  int count = 0;
  int most_trials = 0;
};
void DrawSteps(const DrawnSteps& of,
               RandomStream& random,
               const std::function<bool(const Eigen::VectorXd&)>& take);

}  // namespace fathom
