// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_info.h"
#include "fathom/vehicle/effect_law.h"
#include "fathom/vehicle/effects/bounds.h"
#include "fathom/vehicle/effects/confusions.h"
#include "fathom/vehicle/effects/natural_units.h"
#include "fathom/vehicle/effects/quantities.h"

#include <cmath>

// How the water resists the motion. Equations: docs/effects.md.
namespace fathom {

struct DampingAsymmetry {
  static EffectInfo Info() {
    return {.name = "damping_asymmetry",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "ratio",
                            .quantity = kRatio,
                            .null = 0.0,
                            .lower = -1.0,
                            .upper = 20.0,
                            .drawn = {0.2, 2.0, natural::One}}},
            .cause = "drag that differs between the two directions",
            .advice = "Use a quadratic damping for each direction.",
            .confusions = {&kOneWay}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      const T& v = water.relative_speed;
      return v < T(0.0) ? T(-p[0] * water.quadratic_damping * v * v) : T(0.0);
    }};
  }
};

struct CubicDamping {
  static EffectInfo Info() {
    return {.name = "cubic_damping",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "coefficient",
                            .quantity = kCubicDrag,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .drawn = {0.1, 1.0, natural::CubicDrag}}},
            .cause = "drag that grows faster with speed than quadratic damping",
            .advice = "Use the model only at the speeds of this log, or keep the cubic term.",
            .confusions = {&kLargeCommands, &kDragOverSpeed}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      const T& v = water.relative_speed;
      return p[0] * v * v * v;
    }};
  }
};

struct CoulombFriction {
  static EffectInfo Info() {
    return {.name = "coulomb_friction",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "force",
                            .quantity = kForce,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .drawn = {0.03, 0.4, natural::Force}}},
            .cause = "dry friction, for example of a tether or a guide rail",
            .advice = "Look at what the tether or the rail touches.",
            .confusions = {&kSmallCommands, &kDragOverSpeed}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      using std::tanh;
      constexpr double kSlowest = 0.005;  // [m/s] or [rad/s]
      return p[0] * tanh(water.speed / kSlowest);
    }};
  }
};

struct SteadyCurrent {
  static EffectInfo Info() {
    return {.name = "steady_current",
            .place = Place::kWater,
            .scope = Scope::kRun,
            .parameters = {{.name = "speed",
                            .quantity = kSpeed,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.05, 0.7, natural::Speed, true}}},
            .cause = "a steady current",
            .advice =
                "Repeat the run on the opposite heading: a current changes sign, a bias does "
                "not.",
            .confusions = {&kSpeedAtRest}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.relative_speed = [](const T* p, const T& speed) { return speed - p[0]; }};
  }
};

struct FluidMemory {
  static EffectInfo Info() {
    return {.name = "fluid_memory",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "coefficient",
                            .quantity = kLinearDrag,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .drawn = {0.2, 1.5, natural::LinearDrag}},
                           {.name = "time_constant",
                            .quantity = kDuration,
                            .null = kAny,
                            .lower = 0.3,
                            .upper = 100.0,
                            .search = Search::kShape,
                            .trials = {0.6, 1.5, 4.0, 10.0, 25.0},
                            .drawn = {0.6, 15.0, natural::One}}},
            .cause = "a wake that lags behind the motion",
            .advice = "Keep the memory term for manoeuvres as quick as its time constant."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance =
                [](const T* p, const WaterState<T>& water, const Instant<T>&) {
                  const T ahead = water.speed - water.memory;
                  return p[0] * ahead;
                },
            .memory_rate =
                [](const T* p, const T& memory, const T& speed) {
                  const T ahead = speed - memory;
                  return ahead / p[1];
                }};
  }
};

}  // namespace fathom
