// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_law.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace fathom {

// An effect at work in one scalar, with its numbers.
template <typename T>
struct StackedEffect {
  const EffectLaw<T>* law = nullptr;  // not owned
  EffectSetting setting;
  bool has_partner = false;
  std::vector<T> values;  // in the order of EffectInfo::parameters
};

// All that acts along one DOF, in the order in which it acts (docs/effects.md, "Hooks"): what every
// integrator asks of effects, it asks here.
//
// `at(k)` gives the Instant of effect k and is called for those that need it. States and memories
// are arrays with a place for each effect.
template <typename T>
class EffectStack {
 public:
  EffectStack() = default;
  explicit EffectStack(std::vector<StackedEffect<T>> effects) : effects_(std::move(effects)) {}

  bool empty() const { return effects_.empty(); }
  std::size_t size() const { return effects_.size(); }
  const StackedEffect<T>& operator[](std::size_t k) const { return effects_[k]; }

  // Whether any of the effects has the hook.
  template <typename Hook>
  bool Has(Hook EffectLaw<T>::*hook) const {
    return std::any_of(effects_.begin(), effects_.end(), [&](const StackedEffect<T>& effect) {
      return effect.law->*hook != nullptr;
    });
  }

  // Those with the hook, and those without, in their order.
  template <typename Hook>
  std::pair<EffectStack, EffectStack> SplitBy(Hook EffectLaw<T>::*hook) const {
    std::pair<EffectStack, EffectStack> with_and_without;
    for (const StackedEffect<T>& effect : effects_) {
      auto& stack = effect.law->*hook ? with_and_without.first : with_and_without.second;
      stack.effects_.push_back(effect);
    }
    return with_and_without;
  }

  // Actuator. f(t) = tau(t - Delay()) [s].
  T Delay() const {
    T delay(0.0);
    for (const auto& [law, setting, has_partner, values] : effects_) {
      if (law->delay) delay = delay + law->delay(values.data());
    }
    return delay;
  }

  // Mean force over the `duration` in which `command` is held; moves `states` on.
  template <typename At>
  T MeanForce(const T& command, const T& duration, const At& at, T* states) const {
    T force = command;
    for (std::size_t k = 0; k < effects_.size(); ++k) {
      const auto& [law, setting, has_partner, values] = effects_[k];
      if (law->thrust) force = law->thrust(values.data(), setting, force, at(k));
      if (law->follow) force = law->follow(values.data(), force, duration, &states[k]);
    }
    return force;
  }

  T ForceAtSpeed(const T& mean_force, const T& speed) const {
    T force = mean_force;
    for (const auto& [law, setting, has_partner, values] : effects_) {
      if (law->thrust_at_speed) force = law->thrust_at_speed(values.data(), force, speed);
    }
    return force;
  }

  // Water. Speed through the water.
  T RelativeSpeed(const T& speed) const {
    T relative = speed;
    for (const auto& [law, setting, has_partner, values] : effects_) {
      if (law->relative_speed) relative = law->relative_speed(values.data(), relative);
    }
    return relative;
  }

  // Left-hand side [N] or [N m]. `memories` may be null where no effect has one; water->memory is
  // filled in from them.
  template <typename At>
  T Resistance(WaterState<T>* water, const T* memories, const At& at) const {
    T resistance(0.0);
    for (std::size_t k = 0; k < effects_.size(); ++k) {
      const auto& [law, setting, has_partner, values] = effects_[k];
      if (!law->resistance) continue;
      if (memories) water->memory = memories[k];
      const Instant<T>& now = at(k);
      if (has_partner && setting.dof == Dof::kYaw) {
        resistance = resistance + law->resistance(values.data(), *water, Turning(now, *water));
      } else {
        resistance = resistance + law->resistance(values.data(), *water, now);
      }
    }
    return resistance;
  }

  // What is read along yaw: its own rate is the model's, not the measured one.
  static Instant<T> Turning(Instant<T> now, const WaterState<T>& water) {
    now.partner.yaw_rate = water.speed;
    return now;
  }

  // 0 of those that have no memory.
  void MemoryRates(const T* memories, const T& speed, T* rates) const {
    for (std::size_t k = 0; k < effects_.size(); ++k) {
      const auto& [law, setting, has_partner, values] = effects_[k];
      rates[k] = law->memory_rate ? law->memory_rate(values.data(), memories[k], speed) : T(0.0);
    }
  }

  // Sensor. What it shows of a velocity, where the partners' are known as they were measured.
  template <typename At>
  T Reading(const T& velocity, const At& at) const {
    T reading = velocity;
    for (std::size_t k = 0; k < effects_.size(); ++k) {
      const auto& [law, setting, has_partner, values] = effects_[k];
      if (law->reading) reading = law->reading(values.data(), setting, reading, at(k));
    }
    return reading;
  }

  // What sensors that turn two DOFs show of both; `readings` by Index(Dof).
  void TurnReadings(T* readings) const {
    for (const auto& [law, setting, has_partner, values] : effects_) {
      if (!law->both_readings) continue;
      law->both_readings(
          values.data(), &readings[Index(setting.dof)], &readings[Index(setting.partner)]);
    }
  }

  // Moves `shown`, what a lagging sensor shows, on over a `duration` in which it would show `begin`
  // to `end` without lag.
  void FollowReading(const T& begin, const T& end, const T& duration, T* shown) const {
    for (const auto& [law, setting, has_partner, values] : effects_) {
      if (law->follow_reading) law->follow_reading(values.data(), begin, end, duration, shown);
    }
  }

  // Pose stamp = true time + PoseDelay() [s].
  T PoseDelay() const {
    T delay(0.0);
    for (const auto& [law, setting, has_partner, values] : effects_) {
      if (law->pose_delay) delay = delay + law->pose_delay(values.data());
    }
    return delay;
  }

  // What the pose shows of a displacement.
  template <typename At>
  T Displacement(const T& displacement, const At& at) const {
    T shown = displacement;
    for (std::size_t k = 0; k < effects_.size(); ++k) {
      const auto& [law, setting, has_partner, values] = effects_[k];
      if (law->displacement) shown = law->displacement(values.data(), shown, at(k));
    }
    return shown;
  }

 private:
  std::vector<StackedEffect<T>> effects_;
};

}  // namespace fathom
