// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_noise.h"

#include "fathom/base/input_error.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/planning/stamp_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestCoupledPeriod = 0.1;  // of the stamps in the search [s]
constexpr int kMostCoupledStamps = 3000;
constexpr double kDefaultWindow = 20.0;  // of a fit [s]

// How the noise of a DOF is known, and its size and colour over samples.
void SetNoise(const CoupledPlanRequest& request, Dof dof, CoupledPlan* plan) {
  const auto at = static_cast<std::size_t>(Index(dof));
  const double given = request.limits.noise[at];
  if (!std::isnan(given)) {
    plan->noise[at] = given;
    plan->noise_source[at] = NoiseSource::kLimits;
    return;
  }
  // The mean size of a normal number is sqrt(2 / pi) of its standard deviation.
  plan->noise[at] = std::sqrt(std::numbers::pi / 2.0) * request.model.train[at].mae;
  const auto& colour = request.model.residual_autoregression[at];
  plan->noise_source[at] = colour ? NoiseSource::kLog : NoiseSource::kLogTakenAsWhite;
  if (colour) plan->colour[at] = *colour;
}

StampNoise NoiseAtStamps(const CoupledPlanRequest& request,
                         const CoupledPlan& plan,
                         Dof dof,
                         int num_samples) {
  const auto at = static_cast<std::size_t>(Index(dof));
  try {
    return MeansOf(plan.noise[at], plan.colour[at], num_samples);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: of {}, {}", request.name, Name(dof), error.what()));
  }
}

}  // namespace

void SetMeasurement(const CoupledPlanRequest& request, CoupledPlan* plan) {
  plan->rate = request.limits.rate;
  for (const Dof dof : request.model.model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    const FitFigures& fit = request.model.train[at];
    if (std::isnan(plan->rate)) plan->rate = fit.num_samples / fit.duration;
    SetNoise(request, dof, plan);
    RequireMeasured(request.name,
                    plan->noise[at],
                    CoupledLimits::kNoLimit,
                    fmt::format("how much its fit missed of {}", Name(dof)),
                    fmt::format("noise: {{{}: 0.01}}", Name(dof)));
  }
  RequireMeasured(request.name,
                  plan->rate,
                  kGreatestRate,
                  "how often its log measured the velocities",
                  "rate: 10");
}

WrenchMeasurement MeasurementFor(const CoupledPlanRequest& request, const CoupledPlan& plan) {
  const double longest = std::max(kLongestCoupledPeriod, plan.duration / kMostCoupledStamps);
  const int num_samples = std::max(1, static_cast<int>(std::round(longest * plan.rate)));
  WrenchMeasurement measurement;
  measurement.period = num_samples / plan.rate;
  for (const Dof dof : request.model.model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    StampNoise noise = NoiseAtStamps(request, plan, dof, num_samples);
    measurement.noise[at] = noise.velocity;
    measurement.colour[at] = std::move(noise.colour);
  }
  const double window = std::max(WindowOf(request), measurement.period);
  measurement.window = plan.duration / std::max(1.0, std::round(plan.duration / window));
  return measurement;
}

Autoregression NoiseOfSample(const CoupledPlanRequest& request, const CoupledPlan& plan, Dof dof) {
  StampNoise noise = NoiseAtStamps(request, plan, dof, 1);
  noise.colour.innovation_variance *= noise.velocity * noise.velocity;
  return noise.colour;
}

double WindowOf(const CoupledPlanRequest& request) {
  const double horizon = request.model.horizon;
  return std::isfinite(horizon) && horizon > 0.0 ? horizon : kDefaultWindow;
}

}  // namespace fathom
