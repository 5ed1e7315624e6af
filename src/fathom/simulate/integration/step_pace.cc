// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/integration/step_pace.h"

#include "fathom/base/flattened.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr double kLongestStep = 0.1;         // [s]
constexpr double kShortestClassical = 0.02;  // [s]

}  // namespace

StepPace::StepPace(const EffectInputs& inputs, const ScalarModel<double>& model)
    : model_(model),
      instants_(inputs, model.effects),
      water_(model, false, &instants_),
      acts_on_water_(ActsOnWater(model.effects)) {}

StepPace::Pace StepPace::From(const RunState<double>& state, double command, double s) {
  const UncoupledModel<double>& baseline = model_.baseline;
  const double reached = std::abs(state.velocity) +
                         std::abs(command - baseline.buoyancy) * kLongestStep / baseline.inertia;
  const double rate = std::abs(baseline.DampingSlope(reached)) / baseline.inertia;
  const double of_baseline = std::min(kLongestStep, kMostRateTimesStep / rate);
  if (!acts_on_water_) return {of_baseline, false};
  const double with_effects =
      std::min(of_baseline, kMostRateTimesStep / WaterRate(state, command, s));
  if (with_effects > kShortestClassical) return {with_effects, false};
  return {of_baseline, true};
}

FATHOM_FLATTENED double StepPace::SpeedRate(const RunState<double>& state,
                                            double speed,
                                            double command,
                                            double s) {
  constexpr double kProbe = 1e-4;  // of speed
  RunState<double> at = state;
  at.velocity = speed - kProbe;
  const double below = water_.Acceleration(at, command, s);
  at.velocity = speed + kProbe;
  return (water_.Acceleration(at, command, s) - below) / (2.0 * kProbe);
}

bool StepPace::IsShortEnough(const RunState<double>& before,
                             double slope,
                             const RunState<double>& after,
                             double command,
                             double s,
                             double h,
                             double rate) {
  const double v0 = before.velocity, v1 = after.velocity;
  double change = std::abs(SpeedRate(after, v1, command, s + h) - rate);
  if (v0 * v1 < 0.0 || v0 * (v0 + h * slope) < 0.0) {
    change = std::max(change, std::abs(SpeedRate(after, 0.0, command, s + h) - rate));
  }
  return change * h < 2.0 * kMostRateTimesStep;
}

// With the effects. It costs as much as a step: where it is far from shortening one it is looked at
// now and then.
double StepPace::WaterRate(const RunState<double>& state, double command, double s) {
  constexpr int kLookAgain = 5;  // steps
  if (5.0 * water_rate_ * kLongestStep < kMostRateTimesStep && ++since_look_ < kLookAgain) {
    return water_rate_;
  }
  since_look_ = 0;
  water_rate_ = 0.0;
  for (const double speed : {state.velocity, 0.0}) {
    water_rate_ = std::max(water_rate_, std::abs(SpeedRate(state, speed, command, s)));
  }
  return water_rate_;
}

}  // namespace fathom
