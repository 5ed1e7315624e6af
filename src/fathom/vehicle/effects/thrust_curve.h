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

// How much thrust a command gives. Equations: docs/effects.md.
namespace fathom {

struct ThrustDeadZone {
  static EffectInfo Info() {
    return {.name = "thrust_dead_zone",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "width",
                            .quantity = kForce,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kSize,
                            .trials = {0.02, 0.05, 0.1, 0.2, 0.4, 0.8},
                            .drawn = {0.05, 0.6, natural::Force}}},
            .cause = "a thruster dead zone",
            .advice =
                "Look for the dead band of the speed controllers around neutral and add it to "
                "the command.",
            .confusions = {&kSmallCommands}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.thrust = [](const T* p, const EffectSetting&, const T& force, const Instant<T>&) {
      if (force > p[0]) return force - p[0];
      if (force < -p[0]) return force + p[0];
      return T(0.0);
    }};
  }
};

struct ThrustSaturation {
  static EffectInfo Info() {
    return {.name = "thrust_saturation",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "limit",
                            .quantity = kForce,
                            .null = kInfinity,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kSize,
                            .trials = {0.4, 0.6, 0.8, 1.0, 1.2, 1.5, 1.8, 2.2, 2.7},
                            .drawn = {0.25, 0.85, natural::PeakForce}}},
            .cause = "a saturation of the thrusters",
            .advice = "Keep commands below the limit, or clamp them there before simulating.",
            .confusions = {&kLargeCommands}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.thrust = [](const T* p, const EffectSetting&, const T& force, const Instant<T>&) {
      if (force > p[0]) return p[0];
      if (force < -p[0]) return -p[0];
      return force;
    }};
  }
};

struct ThrustCurve {
  static EffectInfo Info() {
    return {.name = "thrust_curve",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "exponent",
                            .quantity = kRatio,
                            .null = 1.0,
                            .lower = 0.2,
                            .upper = 5.0,
                            .search = Search::kSize,
                            .trials = {0.5, 0.8, 1.1, 1.4, 2.0},
                            .drawn = {0.5, 2.0, natural::One}}},
            .uses_reference_force = true,
            .cause = "a thrust curve other than the assumed one",
            .advice = "Check the thrust law in a bollard test (linear or quadratic)."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {
        .thrust = [](const T* p, const EffectSetting& setting, const T& force, const Instant<T>&) {
          using std::abs;
          using std::pow;
          if (force == T(0.0)) return force;
          const T size = pow(abs(force) / setting.reference_force, p[0]) * setting.reference_force;
          return force > T(0.0) ? size : T(-size);
        }};
  }
};

struct ThrustAsymmetry {
  static EffectInfo Info() {
    return {.name = "thrust_asymmetry",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "reverse_loss",
                            .quantity = kRatio,
                            .null = 0.0,
                            .lower = -1.0,
                            .upper = 0.98,
                            .drawn = {0.05, 0.5, natural::One}}},
            .cause = "unequal thrust ahead and in reverse",
            .advice = "Use separate thrust coefficients for reverse.",
            .confusions = {&kOneWay}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.thrust = [](const T* p, const EffectSetting&, const T& force, const Instant<T>&) {
      return force < T(0.0) ? T(force * (1.0 - p[0])) : force;
    }};
  }
};

struct ThrustInflowLoss {
  static EffectInfo Info() {
    return {.name = "thrust_inflow_loss",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "coefficient",
                            .quantity = kInflow,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .drawn = {0.05, 0.4, natural::Inflow}}},
            .cause = "a loss of thrust as the inflow to the propellers grows",
            .advice = "Use a thrust law that includes the advance ratio."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.thrust_at_speed = [](const T* p, const T& force, const T& speed) {
      using std::abs;
      using std::sqrt;
      if (force == T(0.0)) return force;
      return force - p[0] * sqrt(abs(force)) * speed;
    }};
  }
};

}  // namespace fathom
