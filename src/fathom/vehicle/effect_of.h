// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"
#include "fathom/vehicle/effect_law.h"

namespace fathom {

// Which hooks the struct E has. Asked of plain numbers: it has each for every scalar or for none.
template <typename E, typename T = double>
constexpr EffectHooks kHooksOf = {.delay = requires(const T* p){E::Delay(p);
}  // namespace fathom
, .thrust = requires(const T* p, EffectSetting s, T x, Instant<T> i) { E::Thrust(p, s, x, i); }
, .follow = requires(const T* p, T x, T* state) { E::Follow(p, x, x, state); }
, .thrust_at_speed = requires(const T* p, T x) { E::ThrustAtSpeed(p, x, x); }
, .relative_speed = requires(const T* p, T x) { E::RelativeSpeed(p, x); }
, .resistance = requires(const T* p, EffectSetting s, WaterState<T> w, Instant<T> i) {
  E::Resistance(p, s, w, i);
}
, .memory_rate = requires(const T* p, T x) { E::MemoryRate(p, x, x); }
, .reading = requires(const T* p, EffectSetting s, T x, Instant<T> i) { E::Reading(p, s, x, i); }
, .follow_reading = requires(const T* p, T x, T* state) { E::FollowReading(p, x, x, x, state); }
, .pose_delay = requires(const T* p) { E::PoseDelay(p); }
, .displacement = requires(const T* p, T x, Instant<T> i) { E::Displacement(p, x, i); }
,
}
;

// Makes an Effect of a struct E that has
//
//   static EffectInfo Info();
//
// and, as static templates over the scalar T, those hooks of EffectLaw<T> that it needs, under the
// same names and with the same arguments. docs/adding_an_effect.md shows one. The source file that
// uses this includes <ceres/jet.h> and sees the whole of E.
template <typename E>
class EffectOf final : public Effect {
 public:
  const EffectInfo& info() const override { return info_; }
  const EffectLaws& laws() const override { return laws_; }

 private:
  template <typename T>
  struct Law final : EffectLaw<T> {
    T Delay(const T* p) const override {
      if constexpr (kHooks.delay) return E::Delay(p);
      return T(0.0);
    }
    T Thrust(const T* p,
             const EffectSetting& setting,
             const T& force,
             const Instant<T>& now) const override {
      if constexpr (kHooks.thrust) return E::Thrust(p, setting, force, now);
      return force;
    }
    T Follow(const T* p, const T& target, const T& duration, T* state) const override {
      if constexpr (kHooks.follow) return E::Follow(p, target, duration, state);
      *state = target;
      return target;
    }
    T ThrustAtSpeed(const T* p, const T& force, const T& speed) const override {
      if constexpr (kHooks.thrust_at_speed) return E::ThrustAtSpeed(p, force, speed);
      return force;
    }
    T RelativeSpeed(const T* p, const T& speed) const override {
      if constexpr (kHooks.relative_speed) return E::RelativeSpeed(p, speed);
      return speed;
    }
    T Resistance(const T* p,
                 const EffectSetting& setting,
                 const WaterState<T>& water,
                 const Instant<T>& now) const override {
      if constexpr (kHooks.resistance) return E::Resistance(p, setting, water, now);
      return T(0.0);
    }
    T MemoryRate(const T* p, const T& memory, const T& speed) const override {
      if constexpr (kHooks.memory_rate) return E::MemoryRate(p, memory, speed);
      return T(0.0);
    }
    T Reading(const T* p,
              const EffectSetting& setting,
              const T& reading,
              const Instant<T>& now) const override {
      if constexpr (kHooks.reading) return E::Reading(p, setting, reading, now);
      return reading;
    }
    void FollowReading(
        const T* p, const T& begin, const T& end, const T& duration, T* state) const override {
      if constexpr (kHooks.follow_reading) {
        E::FollowReading(p, begin, end, duration, state);
      } else {
        *state = end;
      }
    }
    T PoseDelay(const T* p) const override {
      if constexpr (kHooks.pose_delay) return E::PoseDelay(p);
      return T(0.0);
    }
    T Displacement(const T* p, const T& displacement, const Instant<T>& now) const override {
      if constexpr (kHooks.displacement) return E::Displacement(p, displacement, now);
      return displacement;
    }
  };

  static constexpr EffectHooks kHooks = kHooksOf<E>;

  const Law<double> plain_{};
  const Law<SmallJet> small_jet_{};
  const Law<LargeJet> large_jet_{};
  const EffectInfo info_ = E::Info();
  const EffectLaws laws_ = {kHooks, &plain_, &small_jet_, &large_jet_};
};

}  // namespace fathom
