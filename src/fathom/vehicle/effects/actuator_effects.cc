// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effects/actuator_effects.h"

#include "fathom/vehicle/effect_of.h"
#include "fathom/vehicle/effects/quantities.h"
#include "fathom/vehicle/effects/switched_on.h"

#include <array>
#include <cmath>
#include <limits>

#include <ceres/jet.h>

namespace fathom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAny = std::numeric_limits<double>::quiet_NaN();

struct TimeOffset {
  static EffectInfo Info() {
    return {.name = "time_offset",
            .place = Place::kActuator,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "offset",
                            .quantity = kDuration,
                            .null = 0.0,
                            .lower = -6.0,
                            .upper = 6.0,
                            .search = Search::kSize,
                            .trials = {-3.0, -1.0, -0.3, -0.1, 0.1, 0.3, 1.0, 2.0, 4.0}}},
            .cause =
                "the command reaches the thrusters late, or the clocks of the command and the "
                "motion log disagree",
            .advice = "Compare the stamps of both streams against one clock."};
  }
  template <typename T>
  static T Delay(const T* p) {
    return p[0];
  }
};

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
                            .trials = {0.02, 0.05, 0.1, 0.2, 0.4, 0.8}}},
            .cause = "small commands give no thrust",
            .advice =
                "Look for the dead band of the speed controllers around neutral and add it to "
                "the command."};
  }
  template <typename T>
  static T Thrust(const T* p, const EffectSetting&, const T& force, const Instant<T>&) {
    if (force > p[0]) return force - p[0];
    if (force < -p[0]) return force + p[0];
    return T(0.0);
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
                            .trials = {0.4, 0.6, 0.8, 1.0, 1.2, 1.5, 1.8, 2.2, 2.7}}},
            .cause = "more thrust was commanded than the thrusters give",
            .advice = "Keep commands below the limit, or clamp them there before simulating."};
  }
  template <typename T>
  static T Thrust(const T* p, const EffectSetting&, const T& force, const Instant<T>&) {
    if (force > p[0]) return p[0];
    if (force < -p[0]) return -p[0];
    return force;
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
                            .trials = {0.5, 0.8, 1.1, 1.4, 2.0}}},
            .cause = "thrust does not grow with the command as it was assumed to",
            .advice =
                "Check the thrust law (linear where it is quadratic, or the reverse) on a "
                "bollard."};
  }
  template <typename T>
  static T Thrust(const T* p, const EffectSetting& setting, const T& force, const Instant<T>&) {
    using std::abs;
    using std::pow;
    if (force == T(0.0)) return force;
    const T size = pow(abs(force) / setting.reference_force, p[0]) * setting.reference_force;
    return force > T(0.0) ? size : T(-size);
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
                            .upper = 0.98}},
            .cause = "the propellers give another thrust in reverse than ahead",
            .advice = "Use thrust coefficients of their own for reverse."};
  }
  template <typename T>
  static T Thrust(const T* p, const EffectSetting&, const T& force, const Instant<T>&) {
    return force < T(0.0) ? T(force * (1.0 - p[0])) : force;
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
                            .trials = {1e-4}}},
            .cause = "thrust faded over the run, as it does when the battery sags",
            .advice = "Log the supply voltage and scale the thrust by it."};
  }
  template <typename T>
  static T Thrust(const T* p, const EffectSetting&, const T& force, const Instant<T>& now) {
    return force * (1.0 - p[0] * now.time);
  }
};

// A thruster that fails loses all, 1, which is therefore not the bound.
struct ThrustStepLoss {
  static EffectInfo Info() {
    return {.name = "thrust_step_loss",
            .place = Place::kActuator,
            .scope = Scope::kRun,
            .parameters =
                {{.name = "loss", .quantity = kRatio, .null = 0.0, .lower = 0.0, .upper = 1.5},
                 {.name = "time",
                  .quantity = kDuration,
                  .null = kAny,
                  .lower = 0.0,
                  .upper = kInfinity,
                  .search = Search::kTimeOfRun}},
            .cause = "part of the thrust was lost from one moment to the next",
            .advice = "Look for a fouled or failed thruster at that time."};
  }
  template <typename T>
  static T Thrust(const T* p, const EffectSetting&, const T& force, const Instant<T>& now) {
    return force * (1.0 - p[0] * SwitchedOn(T(now.time - p[1])));
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
                            .trials = {0.15, 0.3, 0.6, 1.2, 2.5, 5.0, 10.0}}},
            .cause = "thrust changes no faster than the speed controllers' ramp",
            .advice = "Look up the ramp of the speed controllers, or command no faster."};
  }
  template <typename T>
  static T Follow(const T* p, const T& target, const T& duration, T* state) {
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
                            .trials = {0.1, 0.3, 1.0, 3.0}}},
            .cause = "the propellers take time to reach their speed",
            .advice = "Log the propellers' speed and use it in place of the command."};
  }
  template <typename T>
  static T Follow(const T* p, const T& target, const T& duration, T* state) {
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
                            .upper = kInfinity}},
            .cause = "thrust falls as water flows into the propellers faster",
            .advice = "Use a thrust law with the advance ratio."};
  }
  template <typename T>
  static T ThrustAtSpeed(const T* p, const T& force, const T& speed) {
    using std::abs;
    using std::sqrt;
    if (force == T(0.0)) return force;
    return force - p[0] * sqrt(abs(force)) * speed;
  }
};

}  // namespace

std::span<const Effect* const> ActuatorEffects() {
  static const EffectOf<TimeOffset> time_offset;
  static const EffectOf<ThrustDeadZone> dead_zone;
  static const EffectOf<ThrustSaturation> saturation;
  static const EffectOf<ThrustCurve> curve;
  static const EffectOf<ThrustAsymmetry> asymmetry;
  static const EffectOf<ThrustFade> fade;
  static const EffectOf<ThrustStepLoss> step_loss;
  static const EffectOf<ThrustSlewLimit> slew_limit;
  static const EffectOf<ThrusterLag> lag;
  static const EffectOf<ThrustInflowLoss> inflow_loss;
  static const std::array<const Effect*, 10> effects = {&time_offset,
                                                        &dead_zone,
                                                        &saturation,
                                                        &curve,
                                                        &asymmetry,
                                                        &fade,
                                                        &step_loss,
                                                        &slew_limit,
                                                        &lag,
                                                        &inflow_loss};
  return effects;
}

}  // namespace fathom
