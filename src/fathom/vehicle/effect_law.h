// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <string>

namespace ceres {
template <typename T, int N>
struct Jet;
}

namespace fathom {

// Differentiated scalars of the simulation: up to eight or up to sixteen derivatives.
using SmallJet = ceres::Jet<double, 8>;
using LargeJet = ceres::Jet<double, 16>;

// What an effect is told once per log.
struct EffectSetting {
  Dof dof = Dof::kSurge;         // the one that is modelled
  Dof partner = Dof::kYaw;       // the one that takes part, if any
  double reference_force = 1.0;  // RMS of the command of the log it was identified from [N, N m]
  std::string log = {};          // of several that share a model, the one it acts in; empty: all

  bool ActsIn(const std::string& other) const { return log.empty() || log == other; }
};

// What is measured of the other DOFs at one instant.
template <typename T>
struct PartnerReading {
  T velocity{0.0};  // of the partner [m/s] or [rad/s]
  T yaw_rate{0.0};  // [rad/s]
  T force{0.0};     // commanded of the partner [N] or [N m]
};

template <typename T>
struct Instant {
  T time{0.0};  // since the log's first command sample [s]
  PartnerReading<T> partner;
};

// The vehicle in the water at one instant, as the baseline model sees it.
template <typename T>
struct WaterState {
  T speed{0.0};           // over ground [m/s] or [rad/s]
  T relative_speed{0.0};  // through the water
  T position{0.0};        // [m] or [rad]
  T memory{0.0};          // the effect's own state, see MemoryRate()
  T quadratic_damping{0.0};
  T linear_damping{0.0};
};

// An effect's equation in one scalar: every hook is the identity unless the effect has it. `p` are
// its parameters in the order of EffectInfo. Call through these only where `has` says so.
template <typename T>
class EffectLaw {
 public:
  virtual ~EffectLaw() = default;

  // Actuator, in the order of the catalogue. Delay [s]: f(t) = tau(t - delay).
  virtual T Delay(const T* /*p*/) const { return T(0.0); }
  // Force from force, without memory.
  virtual T Thrust(const T* /*p*/,
                   const EffectSetting& /*setting*/,
                   const T& force,
                   const Instant<T>& /*now*/) const {
    return force;
  }
  // A force that follows `target`, held for `duration`, with a memory of its own: advances `state`
  // (the force reached) and returns the mean force over that time.
  virtual T Follow(const T* /*p*/, const T& target, const T& /*duration*/, T* state) const {
    *state = target;
    return target;
  }
  // Force from force and speed.
  virtual T ThrustAtSpeed(const T* /*p*/, const T& force, const T& /*speed*/) const {
    return force;
  }

  // Water. Speed through the water, from the speed over ground.
  virtual T RelativeSpeed(const T* /*p*/, const T& speed) const { return speed; }
  // What is added to the left-hand side of docs/models.md (1) [N] or [N m].
  virtual T Resistance(const T* /*p*/,
                       const EffectSetting& /*setting*/,
                       const WaterState<T>& /*water*/,
                       const Instant<T>& /*now*/) const {
    return T(0.0);
  }
  // Rate of the effect's own state. Where it starts, InitialState says.
  virtual T MemoryRate(const T* /*p*/, const T& /*memory*/, const T& /*speed*/) const {
    return T(0.0);
  }

  // Sensor, in the order of the catalogue. What the velocity sensor shows.
  virtual T Reading(const T* /*p*/,
                    const EffectSetting& /*setting*/,
                    const T& reading,
                    const Instant<T>& /*now*/) const {
    return reading;
  }
  // A reading that follows one which goes from `begin` to `end` in a straight line over `duration`:
  // advances `state`, the reading shown. Where it starts, InitialState says.
  virtual void FollowReading(
      const T* /*p*/, const T& /*begin*/, const T& end, const T& /*duration*/, T* state) const {
    *state = end;
  }
  // Pose stamp = true time + this [s].
  virtual T PoseDelay(const T* /*p*/) const { return T(0.0); }
  // What the pose's displacement shows at true time `now` [m] or [rad]; `displacement` from the
  // start.
  virtual T Displacement(const T* /*p*/, const T& displacement, const Instant<T>& /*now*/) const {
    return displacement;
  }
};

// Which hooks an effect has.
struct EffectHooks {
  bool delay = false;
  bool thrust = false;
  bool follow = false;
  bool thrust_at_speed = false;
  bool relative_speed = false;
  bool resistance = false;
  bool memory_rate = false;
  bool reading = false;
  bool follow_reading = false;
  bool pose_delay = false;
  bool displacement = false;
};

struct EffectLaws {
  EffectHooks has;
  const EffectLaw<double>* plain = nullptr;
  const EffectLaw<SmallJet>* small_jet = nullptr;
  const EffectLaw<LargeJet>* large_jet = nullptr;

  template <typename T>
  const EffectLaw<T>& In() const;
};

template <>
inline const EffectLaw<double>& EffectLaws::In<double>() const {
  return *plain;
}
template <>
inline const EffectLaw<SmallJet>& EffectLaws::In<SmallJet>() const {
  return *small_jet;
}
template <>
inline const EffectLaw<LargeJet>& EffectLaws::In<LargeJet>() const {
  return *large_jet;
}

}  // namespace fathom
