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

// When a command gives its thrust, and how that changes over a run. Equations: docs/effects.md.
namespace fathom {

struct TimeOffset {
  static EffectInfo Info() {
    return {.name = "time_offset",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "offset",
                            .quantity = kDuration,
                            .null = 0.0,
                            .lower = -15.0,
                            .upper = 15.0,
                            .search = Search::kSize,
                            .trials = {-10.0,
                                       -8.0,
                                       -6.5,
                                       -5.0,
                                       -3.5,
                                       -2.0,
                                       -1.0,
                                       -0.3,
                                       -0.1,
                                       0.1,
                                       0.3,
                                       1.0,
                                       2.0,
                                       3.5,
                                       5.0,
                                       6.5,
                                       8.0,
                                       10.0},
                            .drawn = {0.1, 1.5, natural::One, true}}},
            .cause = "a command delay, or a clock offset between command and motion",
            .advice = "Compare the stamps of both streams against one clock.",
            .confusions = {&kLateThrust, &kLateReading}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.delay = [](const T* p) { return p[0]; }};
  }
};

struct ThrustFade {
  static EffectInfo Info() {
    return {.name = "thrust_fade",
            .place = Place::kActuator,
            .scope = Scope::kRun,
            .parameters = {{.name = "rate",
                            .quantity = kRate,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = 0.1,
                            .trials = {1e-4},
                            .drawn = {0.08, 0.6, natural::PerDuration}}},
            .depends_on_time = true,
            .cause = "thrust that fades over the run, as with a discharging battery",
            .advice = "Log the supply voltage and scale the thrust by it."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.thrust = [](const T* p, const EffectSetting&, const T& force, const Instant<T>& now) {
      return force * (1.0 - p[0] * now.time);
    }};
  }
};

// A thruster that fails loses all, 1, which is therefore not the bound.
struct ThrustStepLoss {
  static EffectInfo Info() {
    return {.name = "thrust_step_loss",
            .place = Place::kActuator,
            .scope = Scope::kRun,
            .parameters = {{.name = "loss",
                            .quantity = kRatio,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = 1.5,
                            .drawn = {0.08, 0.6, natural::One}},
                           {.name = "time",
                            .quantity = kDuration,
                            .null = kAny,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kTimeOfRun,
                            .drawn = {0.2, 0.8, natural::Duration}}},
            .depends_on_time = true,
            .cause = "a sudden loss of thrust",
            .advice = "Look for a fouled or failed thruster at that time."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.thrust = [](const T* p, const EffectSetting&, const T& force, const Instant<T>& now) {
      return force * (1.0 - p[0] * SwitchedOn(T(now.time - p[1])));
    }};
  }
};

struct ThrustSlewLimit {
  static EffectInfo Info() {
    return {.name = "thrust_slew_limit",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "rate",
                            .quantity = kForceRate,
                            .null = kInfinity,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kSize,
                            .trials = {0.15, 0.3, 0.6, 1.2, 2.5, 5.0, 10.0},
                            .drawn = {0.5, 1.5, natural::ForceRate}}},
            .cause = "a rate limit of the thrust, such as the ramp of the speed controllers",
            .advice = "Look up the ramp of the speed controllers, or command slower changes.",
            .confusions = {&kLateThrust, &kLateReading}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.follow = [](const T* p, const T& target, const T& duration, T* state) {
      using std::abs;
      const T start = *state;
      const T way = target - start;
      const T reach = p[0] * duration;
      if (!(abs(way) > reach)) {
        *state = target;
        if (way == T(0.0)) return target;
        const T time_share = abs(way) / reach;  // of the duration, until it is there
        return target - 0.5 * way * time_share;
      }
      *state = way > T(0.0) ? T(start + reach) : T(start - reach);
      return 0.5 * (start + *state);
    }};
  }
};

struct ThrusterLag {
  static EffectInfo Info() {
    return {.name = "thruster_lag",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "time_constant",
                            .quantity = kDuration,
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = 20.0,
                            .search = Search::kSize,
                            .trials = {0.1, 0.3, 1.0, 3.0},
                            .drawn = {0.1, 2.0, natural::One}}},
            .cause = "a lag of the thrusters",
            .advice = "Log the propellers' speed and use it in place of the command.",
            .confusions = {&kLateThrust, &kWhichLag}};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.follow = [](const T* p, const T& target, const T& duration, T* state) {
      using std::exp;
      // Exact for a held target: T df/dt = target - f.
      const T miss = *state - target;
      if (p[0] < T(1e-3) * duration) {
        *state = target;
        return target + miss * p[0] / duration;
      }
      const T kept = exp(-duration / p[0]);
      *state = target + miss * kept;
      return target + miss * (1.0 - kept) * p[0] / duration;
    }};
  }
};

}  // namespace fathom
