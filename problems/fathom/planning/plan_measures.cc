// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_measures.h"

#include "fathom/planning/flown_information.h"
#include "fathom/planning/information.h"
#include "fathom/planning/rival_separation.h"

#include <cmath>

namespace fathom {
namespace {

constexpr double kEnough = 6.0;              // of a separation, in standard deviations
constexpr double kShareOfInformation = 0.3;  // beside separations

// How much the log so far counts beside the next one, which is to stand alone: ballast and thrust
// change from day to day. It settles what the first blocks leave open.
constexpr double kWeightSoFar = 0.03;

}  // namespace

// Of the parameters in their standard deviations so far, so that units do not count.
CommandMeasure InformationMeasure(const PlanRequest& request, const StampNoise& noise) {
  const Eigen::VectorXd stds = request.model.covariance.diagonal().cwiseSqrt();
  const Eigen::MatrixXd known =
      kWeightSoFar * InverseOf(request.model.covariance) + FlownInformation(request);
  return [=, model = request.model.Extended(), dof = request.model.dof](
             const HeldCommand& command, std::span<const double> stamps) {
    MeasuredCommand measured;
    MotionDerivatives derivatives;
    auto motion = MotionUnder(model, dof, command, stamps, &derivatives);
    if (!motion) return measured;
    const Eigen::MatrixXd sum = known + InformationOf(derivatives, noise);
    measured.value = LogDetOf(stds.asDiagonal() * sum * stds.asDiagonal());
    measured.motion = *std::move(motion);
    return measured;
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
    MeasuredCommand measured = information(command, stamps);
    if (!std::isfinite(measured.value)) return measured;
    measured.value *= kShareOfInformation;
    const std::vector<double> separations = QuickSeparations(rivals, {dof, command, stamps, noise});
    if (separations.empty()) return MeasuredCommand();
    for (const double sigmas : separations) {
      const double squared = sigmas * sigmas;
      measured.value += std::log1p(squared / (1.0 + squared / (kEnough * kEnough)));
    }
    return measured;
  };
}

}  // namespace fathom
