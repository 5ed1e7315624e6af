// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_info.h"
#include "fathom/vehicle/effect_law.h"
#include "fathom/vehicle/effects/bounds.h"
#include "fathom/vehicle/effects/confusions.h"
#include "fathom/vehicle/effects/natural_units.h"
#include "fathom/vehicle/effects/quantities.h"
#include "fathom/vehicle/effects/switched_on.h"

#include <cmath>

// Forces that come from where or when the vehicle is. Equations: docs/effects.md.
namespace fathom {

struct PositionStiffness {
  static EffectInfo Info() {
    return {.name = "position_stiffness",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "stiffness",
                            .quantity = kStiffness,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.05, 0.6, natural::Stiffness}}},
            .cause =
                "a force that grows with the displacement, such as the pull of a tether, "
                "buoyancy that changes with depth, or a restoring moment",
            .advice = "Give the tether slack, or keep the spring in the model.",
            .confusions = {&kSpringOrRighting, &kSpringOrDrift, &kSpringOrStep}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      return p[0] * water.position;
    }};
  }
};

struct RightingMoment {
  static bool TiltsTheVehicle(Dof dof) { return dof == Dof::kRoll || dof == Dof::kPitch; }

  static EffectInfo Info() {
    return {
        .name = "righting_moment",
        .place = Place::kWater,
        .scope = Scope::kVehicle,
        .parameters = {{.name = "moment",
                        .quantity = kMomentOfSine,
                        .null = 0.0,
                        .lower = -kInfinity,
                        .upper = kInfinity,
                        .drawn = {0.1, 1.0, natural::RightingMoment}}},
        .acts_along = TiltsTheVehicle,
        .needs_displacement = true,
        .cause = "a righting moment, that of weight below the centre of buoyancy",
        .advice = "Keep it in the model. Below zero the vehicle is top-heavy: move weight down.",
        .confusions = {&kSpringOrRighting, &kSpringOrDrift, &kSpringOrStep}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      using std::sin;
      return p[0] * sin(water.position);
    }};
  }
};

struct BuoyancyStep {
  static EffectInfo Info() {
    return {.name = "buoyancy_step",
            .place = Place::kWater,
            .scope = Scope::kRun,
            .parameters = {{.name = "jump",
                            .quantity = kForce,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.05, 0.6, natural::Force, true}},
                           {.name = "time",
                            .quantity = kDuration,
                            .null = kAny,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kTimeOfRun,
                            .drawn = {0.2, 0.8, natural::Duration}}},
            .depends_on_time = true,
            .cause = "a step of the constant force",
            .advice = "Look for a payload dropped, water taken in or a snag at that time.",
            .confusions = {&kStepOrDrift, &kSpringOrStep}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>&, const Instant<T>& now) {
      return p[0] * SwitchedOn(T(now.time - p[1]));
    }};
  }
};

struct BuoyancyDrift {
  static EffectInfo Info() {
    return {.name = "buoyancy_drift",
            .place = Place::kWater,
            .scope = Scope::kRun,
            .parameters = {{.name = "slope",
                            .quantity = kForceRate,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .trials = {1e-4},
                            .drawn = {0.08, 1.0, natural::ForceDrift, true}}},
            .depends_on_time = true,
            .cause = "a drift of the constant force",
            .advice = "Look for slowly entering water, or foam that warms or is compressed.",
            .confusions = {&kStepOrDrift, &kSpringOrDrift}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>&, const Instant<T>& now) {
      return p[0] * now.time;
    }};
  }
};

struct PeriodicForce {
  static EffectInfo Info() {
    return {.name = "periodic_force",
            .place = Place::kWater,
            .scope = Scope::kRun,
            .parameters = {{.name = "sine",
                            .quantity = kForce,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.04, 0.5, natural::Force, true}},
                           {.name = "cosine",
                            .quantity = kForce,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.04, 0.5, natural::Force, true}},
                           {.name = "frequency",
                            .quantity = kFrequency,
                            .null = kAny,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kFrequencyOfRun,
                            .drawn = {0.2, 2.0, natural::One}}},
            .depends_on_time = true,
            .cause =
                "a periodic force, such as waves, a slapping tether or another DOF's controller "
                "in a limit cycle",
            .advice = "Look for another process with that period."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>&, const Instant<T>& now) {
      using std::cos;
      using std::sin;
      const T phase = p[2] * now.time;
      return -(p[0] * sin(phase) + p[1] * cos(phase));
    }};
  }
};

}  // namespace fathom
