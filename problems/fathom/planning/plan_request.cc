// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_request.h"

#include "fathom/base/input_error.h"
#include "fathom/planning/stamp_noise.h"
#include "fathom/planning/thruster_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace fathom {

void RequireOwnEffects(const ExtendedModel& model, Dof dof, const std::string& name) {
  for (const ActiveEffect& active : model.effects) {
    const EffectInfo& info = active.effect->info();
    if (!info.has_partner() && !info.needs_pose) continue;
    throw InputError(
        fmt::format("{}: {} needs another DOF or poses, expected effects of {} and its velocity "
                    "alone: others are not planned yet.",
                    name,
                    LabelOf(info, active.setting),
                    Name(dof)));
  }
}

void RequirePlannable(const PlanRequest& request) {
  const Dof dof = request.model.dof;
  if (request.model.force_unit != ForceUnit(dof)) {
    throw InputError(fmt::format("{}: commands are in {}, expected {}: forces are planned.",
                                 request.name,
                                 request.model.force_unit,
                                 ForceUnit(dof)));
  }
  RequireOwnEffects(request.model.Extended(), dof, request.name);
  for (const RivalModel& rival : request.rivals) {
    RequireOwnEffects(rival.model, dof, request.name);
  }
}

void FitForceToThrusters(const std::string& limits_name, PlanRequest* request) {
  if (!request->thrusters) return;
  const Dof dof = request->model.dof;
  RequireBothWays(dof, *request->thrusters, request->vehicle);
  const double most = request->thrusters->ReachEachWay();
  if (request->limits_are_of_log) request->limits.force = std::min(request->limits.force, most);
  RequireWithinReach(
      {limits_name, "force", request->limits.force}, dof, *request->thrusters, request->vehicle);
}

VelocityMeasurement MeasurementOf(const PlanRequest& request) {
  const FitFigures& fit = request.model.train;
  VelocityMeasurement measurement = request.limits.velocity;
  if (std::isnan(measurement.rate)) measurement.rate = fit.num_samples / fit.duration;
  // The mean size of a normal number is sqrt(2 / pi) of its standard deviation.
  if (std::isnan(measurement.noise))
    measurement.noise = std::sqrt(std::numbers::pi / 2.0) * fit.mae;
  RequireMeasured(request.name,
                  measurement.rate,
                  kGreatestRate,
                  "how often its log measured the velocity",
                  "rate: 10");
  RequireMeasured(request.name,
                  measurement.noise,
                  PlanLimits::kNoLimit,
                  "how much its fit missed",
                  "noise: 0.01");
  return measurement;
}

std::vector<double> ColourOf(const PlanRequest& request) {
  if (!std::isnan(request.limits.velocity.noise) || !request.rivals.empty()) return {};
  if (!request.model.residual_autoregression) return {};
  return PlainestColour(*request.model.residual_autoregression, request.model.train.num_samples);
}

}  // namespace fathom
