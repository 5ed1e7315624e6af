// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_measures.h"

#include "fathom/planning/flown_information.h"
#include "fathom/planning/information.h"
#include "fathom/planning/named_parameters.h"
#include "fathom/planning/rival_separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fathom {
namespace {

constexpr double kEnough = 6.0;              // of a separation, in standard deviations
constexpr double kShareOfInformation = 0.3;  // beside separations

// How much the log so far counts beside the next one, which is to stand alone: ballast and thrust
// change from day to day. It settles what the first blocks leave open.
constexpr double kWeightSoFar = 0.03;

constexpr double kNothing = -std::numeric_limits<double>::infinity();

// What the interval of each parameter is compared with: its value, or its standard deviation so far
// where that is more; that of the offset with the greatest force.
Eigen::VectorXd SizesOf(const PlanRequest& request) {
  Eigen::VectorXd sizes = request.model.covariance.diagonal().cwiseSqrt();
  const std::vector<PlannedParameter> parameters = NamedParameters(request.model);
  for (Eigen::Index i = 0; i < sizes.size(); ++i) {
    const double value = parameters[static_cast<std::size_t>(i)].value;
    sizes[i] = i == kBuoyancy ? request.limits.force : std::max(std::abs(value), sizes[i]);
  }
  return sizes;
}

}  // namespace

CommandMeasure InformationMeasure(const PlanRequest& request, const StampNoise& noise) {
  const Eigen::VectorXd sizes = SizesOf(request);
  const Eigen::MatrixXd known =
      kWeightSoFar * InverseOf(request.model.covariance) + FlownInformation(request);
  return [=, model = request.model.Extended(), dof = request.model.dof](
             const HeldCommand& command, std::span<const double> stamps) {
    Eigen::MatrixXd information = known;
    if (!stamps.empty()) {
      MotionDerivatives derivatives;
      if (!MotionUnder(model, dof, command, stamps, &derivatives)) return kNothing;
      information += InformationOf(derivatives, noise);
    }
    return WorthOfInformation(information, sizes);
  };
}

// docs/plan.md (4): a pair that is decided counts for no more, however far, and one that no run can
// tell apart for nothing. Among commands that decide alike, the one that tells most of the
// parameters.
CommandMeasure SeparationMeasure(const PlanRequest& request,
                                 std::vector<RivalModel> rivals,
                                 const StampNoise& noise) {
  return [=,
          dof = request.model.dof,
          rivals = std::move(rivals),
          information = InformationMeasure(request, noise)](const HeldCommand& command,
                                                            std::span<const double> stamps) {
    double value = kShareOfInformation * information(command, stamps);
    if (!std::isfinite(value) || stamps.empty()) return value;
    const std::vector<double> separations = QuickSeparations(rivals, {dof, command, stamps, noise});
    if (separations.empty()) return kNothing;
    for (const double sigmas : separations) {
      const double squared = sigmas * sigmas;
      value += std::log1p(squared / (1.0 + squared / (kEnough * kEnough)));
    }
    return value;
  };
}

}  // namespace fathom
