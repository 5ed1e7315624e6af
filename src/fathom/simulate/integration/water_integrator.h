// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/flattened.h"
#include "fathom/simulate/integration/instants.h"
#include "fathom/simulate/integration/scalar_model.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace fathom {

// Of a vehicle and the water about it.
template <typename T>
struct RunState {
  T velocity{0.0};
  T position{0.0};
  std::vector<T> memory;  // of each effect; empty if none has one
};

// Without the derivatives.
template <typename T>
void SetValues(const RunState<T>& state, RunState<double>* values) {
  values->velocity = Value(state.velocity);
  values->position = Value(state.position);
  values->memory.clear();
  for (const T& memory : state.memory) values->memory.push_back(Value(memory));
}
template <typename T>
RunState<double> ValuesOf(const RunState<T>& state) {
  RunState<double> values;
  SetValues(state, &values);
  return values;
}

// Whether the water acts otherwise on the vehicle than in the baseline model.
template <typename T>
bool ActsOnWater(const EffectStack<T>& effects) {
  return effects.Has(&EffectLaw<T>::resistance) || effects.Has(&EffectLaw<T>::relative_speed);
}

// Of a step [s] and the rate [1/s] of what it follows, for the classical scheme.
inline constexpr double kMostRateTimesStep = 0.25;

// (exp(rate t) - 1) / rate: how far a slope reaches over `t` [s] where differences grow at a `rate`
// [1/s] other than 0.
template <typename H>
H Reach(double rate, const H& t) {
  using std::expm1;
  return expm1(H(rate * t)) / rate;
}

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
        acts_on_water_(ActsOnWater(model.effects)),
        with_position_(with_position || model.effects.Has(&EffectLaw<T>::resistance)) {
    water_.quadratic_damping = model.baseline.quadratic_damping;
    water_.linear_damping = model.baseline.linear_damping;
    if (!model.effects.Has(&EffectLaw<T>::memory_rate)) return;
    for (RunState<T>* state : {&trial_, &k2_, &k3_, &k4_}) {
      state->memory.resize(model.effects.size());
    }
  }

  FATHOM_FLATTENED T Acceleration(const RunState<T>& at, const T& mean_force, const T& s) {
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

  // Step() by the midpoint rule, of second order at half the cost.
  template <typename H>
  void MidpointStep(const RunState<T>& before,
                    const T& mean_force,
                    const T& s,
                    const H& h,
                    RunState<T>* slope,
                    RunState<T>* after) {
    Slope(before, mean_force, s, slope);
    Move(before, H(0.5 * h), *slope, &trial_);
    Slope(trial_, mean_force, T(s + 0.5 * h), &k2_);
    Move(before, h, k2_, after);
  }

  // Step() where dry friction or strong damping holds the vehicle: one step of the exponential
  // Rosenbrock scheme of second order, which keeps to a balance of forces whatever its length.
  // `rate`: StepPace::SpeedRate() at `before` [1/s]. Where that is slow, the classical step, and
  // false.
  template <typename H>
  bool StiffStep(const RunState<T>& before,
                 const T& mean_force,
                 const T& s,
                 const H& h,
                 double rate,
                 RunState<T>* slope,
                 RunState<T>* after) {
    if (!(rate * Value(h) < -kMostRateTimesStep)) {
      Step(before, mean_force, s, h, slope, after);
      return false;
    }
    Slope(before, mean_force, s, slope);
    const H reach = Reach(rate, h);
    after->velocity = before.velocity + reach * slope->velocity;
    after->position = before.position;
    if (with_position_)
      after->position += h * before.velocity + (reach - h) / rate * slope->velocity;
    if (before.memory.empty()) return true;
    Move(before, h, *slope, &trial_);
    model_.effects.MemoryRates(trial_.memory.data(), after->velocity, k2_.memory.data());
    for (std::size_t k = 0; k < before.memory.size(); ++k) {
      after->memory[k] = before.memory[k] + H(0.5 * h) * (slope->memory[k] + k2_.memory[k]);
    }
    return true;
  }

 private:
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

  const ScalarModel<T>& model_;
  Instants<T>& instants_;
  const bool acts_at_speed_;
  const bool acts_on_water_;
  const bool with_position_;  // for the outputs or for a force that may depend on it

  WaterState<T> water_;
  RunState<T> k2_, k3_, k4_, trial_;  // slopes, and where the next one is taken
};

}  // namespace fathom
