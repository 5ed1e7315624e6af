// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/integration/step_pace.h"

#include "fathom/base/flattened.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr double kShortestClassical = 0.02;  // [s]

// What a vehicle in water does takes longer than some of these; a search that gets here has run
// away to where inertia and a resistance stand in for one another.
constexpr double kQuickest = 100.0;  // [1/s]

// The force over a step is one number. What changes within it asks for shorter ones: thrusters that
// follow, and what happens at a time.
double LongestStep(const EffectInputs& inputs, const ScalarModel<double>& model) {
  const bool follows = model.effects.Has(&EffectLaw<double>::follow);
  return follows || model.depends_on_time ? 0.5 * inputs.steps.longest : inputs.steps.longest;
}

// The highest speed while `force` acts for `h` [s]: no more than it gives to a mass alone, nor than
// where damping holds it.
double SpeedReached(const UncoupledModel<double>& model, double speed, double force, double h) {
  const double linear = model.linear_damping;
  const double steady =
      2.0 * force / (linear + std::sqrt(linear * linear + 4.0 * model.quadratic_damping * force));
  const double alone = speed + force * h / model.inertia;
  return std::isfinite(steady) ? std::min(alone, std::max(speed, steady)) : alone;
}

}  // namespace

StepPace::StepPace(const EffectInputs& inputs, const ScalarModel<double>& model)
    : model_(model),
      instants_(inputs, model.effects),
      water_(model, false, &instants_),
      acts_on_water_(ActsOnWater(model.effects)),
      longest_(LongestStep(inputs, model)) {}

StepPace::Pace StepPace::From(const RunState<double>& state,
                              double command,
                              double s,
                              double wanted) {
  const UncoupledModel<double>& baseline = model_.baseline;
  const double reached = SpeedReached(
      baseline, std::abs(state.velocity), std::abs(command - baseline.buoyancy), longest_);
  double rate = std::abs(baseline.DampingSlope(reached)) / baseline.inertia;
  if (!(rate < kQuickest)) return {};
  if (acts_on_water_)
    rate = std::max(rate, WaterRate(state, command, s, std::min(wanted, longest_)));
  const double classical = std::min(longest_, kMostRateTimesStep / rate);
  if (classical > kShortestClassical) return {classical, rate, false};
  return {longest_, rate, true};
}

FATHOM_FLATTENED double StepPace::SpeedRate(const RunState<double>& state,
                                            double speed,
                                            double command,
                                            double s) {
  constexpr double kProbe = 1e-4;  // of speed
  probe_ = state;
  probe_.velocity = speed - kProbe;
  const double below = water_.Acceleration(probe_, command, s);
  probe_.velocity = speed + kProbe;
  return (water_.Acceleration(probe_, command, s) - below) / (2.0 * kProbe);
}

double StepPace::SwingRate(const RunState<double>& state, double command, double s) {
  constexpr double kProbe = 1e-4;  // of position
  probe_ = state;
  probe_.position = state.position - kProbe;
  const double below = water_.Acceleration(probe_, command, s);
  probe_.position = state.position + kProbe;
  return std::sqrt(std::abs(water_.Acceleration(probe_, command, s) - below) / (2.0 * kProbe));
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

// With the effects. It costs more than a step: where it does not shorten the one that is
// `wanted` [s] it is looked at now and then.
double StepPace::WaterRate(const RunState<double>& state, double command, double s, double wanted) {
  constexpr int kLookAgain = 5;  // steps
  if (water_rate_ * wanted < kMostRateTimesStep && ++since_look_ < kLookAgain) {
    return water_rate_;
  }
  since_look_ = 0;
  water_rate_ = SwingRate(state, command, s);
  for (const double speed : {state.velocity, 0.0}) {
    water_rate_ = std::max(water_rate_, std::abs(SpeedRate(state, speed, command, s)));
  }
  return water_rate_;
}

}  // namespace fathom
