// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/integration/instants.h"
#include "fathom/simulate/integration/scalar_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace fathom {

// Of a vehicle and the water about it.
template <typename T>
struct RunState {
  T velocity{0.0};
  T position{0.0};
  std::vector<T> memory;  // of each effect; empty if none has one
};

// The motion under a mean force, docs/effects.md (1), in steps of the classical Runge-Kutta scheme.
// Times are on the command's clock. Numbers with derivatives are large: what every step needs is
// made once and kept.
template <typename T>
class WaterIntegrator {
 public:
  // All must outlive this. Without `with_position` the position stays where it is.
  WaterIntegrator(const ScalarModel<T>& model, bool with_position, Instants<T>* instants)
      : model_(model),
        instants_(*instants),
        acts_at_speed_(model.effects.Has(&EffectLaw<T>::thrust_at_speed)),
        acts_on_water_(model.effects.Has(&EffectLaw<T>::resistance) ||
                       model.effects.Has(&EffectLaw<T>::relative_speed)),
        with_position_(with_position || model.effects.Has(&EffectLaw<T>::resistance)) {
    water_.quadratic_damping = model.baseline.quadratic_damping;
    water_.linear_damping = model.baseline.linear_damping;
    if (!model.effects.Has(&EffectLaw<T>::memory_rate)) return;
    for (RunState<T>* state : {&trial_, &k2_, &k3_, &k4_}) {
      state->memory.resize(model.effects.size());
    }
  }

  T Acceleration(const RunState<T>& at, const T& mean_force, const T& s) {
    const EffectStack<T>& effects = model_.effects;
    const T force = acts_at_speed_ ? effects.ForceAtSpeed(mean_force, at.velocity) : mean_force;
    if (!acts_on_water_) return model_.baseline.Acceleration(at.velocity, force);
    water_.speed = at.velocity;
    water_.relative_speed = effects.RelativeSpeed(at.velocity);
    water_.position = at.position;
    const auto instant = [&](std::size_t k) -> const Instant<T>& {
      return instants_.OnCommandClock(k, s);
    };
    const T* const memories = at.memory.empty() ? nullptr : at.memory.data();
    const T resistance = effects.Resistance(&water_, memories, instant);
    return model_.baseline.Acceleration(water_.relative_speed, T(force - resistance));
  }

  // From `before` at time `s` over `h`, a number or one with derivatives. `slope` becomes that at
  // `before`; `slope` and `after` have as many memories as `before`.
  template <typename H>
  void Step(const RunState<T>& before,
            const T& mean_force,
            const T& s,
            const H& h,
            RunState<T>* slope,
            RunState<T>* after) {
    const T middle = s + 0.5 * h;
    Slope(before, mean_force, s, slope);
    Move(before, H(0.5 * h), *slope, &trial_);
    Slope(trial_, mean_force, middle, &k2_);
    Move(before, H(0.5 * h), k2_, &trial_);
    Slope(trial_, mean_force, middle, &k3_);
    Move(before, h, k3_, &trial_);
    Slope(trial_, mean_force, T(s + h), &k4_);
    Move(before, H(h / 6.0), *slope, after);
    Move(*after, H(h / 3.0), k2_, after);
    Move(*after, H(h / 3.0), k3_, after);
    Move(*after, H(h / 6.0), k4_, after);
  }

  // How a step may go on from a state.
  struct Pace {
    double longest = 0.0;   // [s], of the classical scheme
    bool is_stiff = false;  // about rest it would be far shorter: StiffStep(), which is checked
  };

  // From `state` at time `s`: by the water's quickest rate now and about rest, where friction
  // turns.
  Pace PaceFrom(const RunState<T>& state, double command, double s) {
    const double inertia = Value(model_.baseline.inertia);
    const double v = Value(state.velocity);
    const double d_L = Value(model_.baseline.linear_damping);
    const double d_Q = Value(model_.baseline.quadratic_damping);
    const double reached =
        std::abs(v) + std::abs(command - Value(model_.baseline.buoyancy)) * kLongestStep / inertia;
    const double rate = std::abs(d_L + 2.0 * d_Q * reached) / inertia;
    const double of_baseline = std::min(kLongestStep, kRateTimesStep / rate);
    if (!acts_on_water_) return {of_baseline, false};
    const double with_effects =
        std::min(of_baseline, kRateTimesStep / WaterRate(state, command, s));
    if (with_effects > kShortestClassical) return {with_effects, false};
    return {of_baseline, true};
  }

  // Step() where dry friction or the like holds the vehicle: one step of the exponential Rosenbrock
  // scheme of second order, which keeps to a balance of forces whatever its length. `rate`:
  // SpeedRate() at `before` [1/s]. Where that is slow, the classical step.
  template <typename H>
  void StiffStep(const RunState<T>& before,
                 const T& mean_force,
                 const T& s,
                 const H& h,
                 double rate,
                 RunState<T>* slope,
                 RunState<T>* after) {
    using std::expm1;
    if (!(rate * Value(h) < -kRateTimesStep)) {
      Step(before, mean_force, s, h, slope, after);
      return;
    }
    Slope(before, mean_force, s, slope);
    const H reach = expm1(H(rate * h)) / rate;
    after->velocity = before.velocity + reach * slope->velocity;
    after->position = before.position;
    if (with_position_) after->position += 0.5 * h * (before.velocity + after->velocity);
    after->memory.resize(before.memory.size());
    for (std::size_t k = 0; k < before.memory.size(); ++k) {
      after->memory[k] = before.memory[k] + h * slope->memory[k];
    }
    // Outputs in between lie on a line: the slope at its begin is of an instant.
    slope->velocity = (after->velocity - before.velocity) / h;
  }

  // How fast a small difference in speed grows, below 0 shrinks [1/s], at `state` and `speed`.
  double SpeedRate(const RunState<T>& state, double speed, double command, double s) {
    constexpr double kProbe = 1e-4;  // of speed
    RunState<T> here = state, there = state;
    here.velocity = T(speed - kProbe);
    there.velocity = T(speed + kProbe);
    const double a0 = Value(Acceleration(here, T(command), T(s)));
    const double a1 = Value(Acceleration(there, T(command), T(s)));
    return (a1 - a0) / (2.0 * kProbe);
  }

  // Whether a stiff step of `h` [s] was short enough for what changes on its way, also where it
  // passes rest, or would at the slope that it began with. `rate` as in StiffStep().
  bool IsShortEnough(const RunState<T>& before,
                     const RunState<T>& slope,
                     const RunState<T>& after,
                     double command,
                     double s,
                     double h,
                     double rate) {
    const double v0 = Value(before.velocity), v1 = Value(after.velocity);
    double change = std::abs(SpeedRate(after, v1, command, s + h) - rate);
    if (v0 * v1 < 0.0 || v0 * (v0 + h * Value(slope.velocity)) < 0.0) {
      change = std::max(change, std::abs(SpeedRate(after, 0.0, command, s + h) - rate));
    }
    return change * h < 2.0 * kRateTimesStep;
  }

 private:
  static constexpr double kLongestStep = 0.1;         // [s]
  static constexpr double kShortestClassical = 0.02;  // [s]
  static constexpr double kRateTimesStep = 0.25;      // at most

  void Slope(const RunState<T>& at, const T& mean_force, const T& s, RunState<T>* slope) {
    slope->velocity = Acceleration(at, mean_force, s);
    if (with_position_) slope->position = at.velocity;
    if (at.memory.empty()) return;
    model_.effects.MemoryRates(at.memory.data(), at.velocity, slope->memory.data());
  }

  template <typename H>
  void Move(const RunState<T>& from, const H& h, const RunState<T>& slope, RunState<T>* to) const {
    to->velocity = from.velocity + h * slope.velocity;
    if (with_position_) to->position = from.position + h * slope.position;
    for (std::size_t k = 0; k < from.memory.size(); ++k) {
      to->memory[k] = from.memory[k] + h * slope.memory[k];
    }
  }

  // With the effects. It costs as much as a step: where it is far from shortening one it is looked
  // at now and then.
  double WaterRate(const RunState<T>& state, double command, double s) {
    constexpr int kLookAgain = 5;  // steps
    if (5.0 * water_rate_ * kLongestStep < kRateTimesStep && ++since_look_ < kLookAgain) {
      return water_rate_;
    }
    since_look_ = 0;
    water_rate_ = 0.0;
    for (const double at : {Value(state.velocity), 0.0}) {
      water_rate_ = std::max(water_rate_, std::abs(SpeedRate(state, at, command, s)));
    }
    return water_rate_;
  }

  const ScalarModel<T>& model_;
  Instants<T>& instants_;
  const bool acts_at_speed_;
  const bool acts_on_water_;
  const bool with_position_;  // for the outputs or for a force that may depend on it

  WaterState<T> water_;
  RunState<T> k2_, k3_, k4_, trial_;  // slopes, and where the next one is taken
  double water_rate_ = std::numeric_limits<double>::infinity();  // when last looked at [1/s]
  int since_look_ = 0;                                           // steps
};

}  // namespace fathom
