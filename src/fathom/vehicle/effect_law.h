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

// An effect's equation in one scalar, as the hooks that it has; null: it leaves things there as
// they are. `p` are its parameters in the order of EffectInfo. EffectStack calls them.
template <typename T>
struct EffectLaw {
  // Actuator, in the order of the catalogue. Delay [s]: f(t) = tau(t - delay).
  T (*delay)(const T* p) = nullptr;
  // Force from force, without memory.
  T(*thrust)
  (const T* p, const EffectSetting& setting, const T& force, const Instant<T>& now) = nullptr;
  // A force that follows `target`, held for `duration`, with a memory of its own: advances `state`
  // (the force reached) and returns the mean force over that time.
  T (*follow)(const T* p, const T& target, const T& duration, T* state) = nullptr;
  // Force from force and speed.
  T (*thrust_at_speed)(const T* p, const T& force, const T& speed) = nullptr;

  // Water. Speed through the water, from the speed over ground.
  T (*relative_speed)(const T* p, const T& speed) = nullptr;
  // What is added to the left-hand side of docs/models.md (1) [N] or [N m].
  T (*resistance)(const T* p, const WaterState<T>& water, const Instant<T>& now) = nullptr;
  // Rate of the effect's own state. Where it starts, InitialState says.
  T (*memory_rate)(const T* p, const T& memory, const T& speed) = nullptr;

  // Sensor, in the order of the catalogue. What the velocity sensor shows, where the partner's
  // velocity is known as it was measured.
  T(*reading)
  (const T* p, const EffectSetting& setting, const T& reading, const Instant<T>& now) = nullptr;
  // The same of a sensor that turns the partner's reading too, from the truth of both.
  void (*both_readings)(const T* p, T* reading, T* partner_reading) = nullptr;
  // A reading that follows one which goes from `begin` to `end` in a straight line over `duration`:
  // advances `state`, the reading shown. Where it starts, InitialState says.
  void (*follow_reading)(const T* p, const T& begin, const T& end, const T& duration, T* state) =
      nullptr;
  // Pose stamp = true time + this [s].
  T (*pose_delay)(const T* p) = nullptr;
  // What the pose's displacement shows at true time `now` [m] or [rad]; `displacement` from the
  // start.
  T (*displacement)(const T* p, const T& displacement, const Instant<T>& now) = nullptr;
};

}  // namespace fathom
