// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/flown_information.h"

#include "fathom/base/input_error.h"
#include "fathom/planning/information.h"
#include "fathom/planning/segment_derivatives.h"

#include <fmt/format.h>

namespace fathom {

Eigen::MatrixXd FlownInformation(const FittedModel& model,
                                 const std::vector<Segment>& flown,
                                 const StampNoise& noise,
                                 const std::string& name) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(model.covariance.rows(), model.covariance.cols());
  for (const Segment& segment : flown) {
    const auto run = RunOver(segment, model.Extended(), model.dof);
    if (!run) {
      throw InputError(fmt::format(
          "--log: {} diverges over the log from t = {:g} s, expected a model of the same vehicle.",
          name,
          segment.time.front()));
    }
    sum += InformationOf(run->derivatives, noise);
  }
  return sum;
}

Eigen::MatrixXd FlownInformation(const PlanRequest& request) {
  return FlownInformation(request.model,
                          request.flown,
                          MeansOf(MeasurementOf(request).noise, ColourOf(request), 1),
                          request.name);
}

}  // namespace fathom
