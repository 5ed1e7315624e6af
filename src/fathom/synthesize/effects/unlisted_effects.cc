// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/unlisted_effects.h"

#include "fathom/synthesize/effects/random_wave.h"
#include "fathom/vehicle/effect_of.h"
#include "fathom/vehicle/effects/bounds.h"
#include "fathom/vehicle/effects/natural_units.h"
#include "fathom/vehicle/effects/quantities.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <ceres/jet.h>

namespace fathom {
namespace {

constexpr Quantity kPowerDrag = {"N (s/m)^1.5", "N m (s/rad)^1.5", 1, -1.5, 0};
constexpr Quantity kWashDrag = {"s^2/m^2", "s^2/rad^2", 0, -2, 0};
constexpr Quantity kPerForce = {"1/N", "1/(N m)", -1, 0, 0};

double Plain(double x) { return x; }
template <typename J>
double Plain(const J& x) {
  return x.a;
}

EffectParameter Parameter(std::string_view name,
                          const Quantity& quantity,
                          double null,
                          const SizeRange& drawn) {
  return {.name = name,
          .quantity = quantity,
          .null = null,
          .lower = 0.0,
          .upper = kInfinity,
          .drawn = drawn};
}

EffectParameter EitherSign(EffectParameter parameter) {
  parameter.lower = -kInfinity;
  return parameter;
}

EffectInfo Unlisted(std::string_view name, Place place, std::vector<EffectParameter> parameters) {
  EffectInfo info;
  info.name = name;
  info.place = place;
  info.scope = Scope::kVehicle;
  info.parameters = std::move(parameters);
  return info;
}

// The thrust follows the command with play: it moves only once the command has moved `width` past
// it.
struct ThrustBacklash {
  static EffectInfo Info() {
    return Unlisted("unlisted.thrust_backlash",
                    Place::kActuator,
                    {Parameter("width", kForce, 0.0, {0.1, 0.6, natural::Force})});
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.follow = [](const T* p, const T& target, const T&, T* state) {
      if (target - *state > p[0]) *state = target - p[0];
      if (*state - target > p[0]) *state = target + p[0];
      return *state;
    }};
  }
};

// Thrust in steps of `step`: a coarse speed setting.
struct ThrustLevels {
  static EffectInfo Info() {
    return Unlisted("unlisted.thrust_levels",
                    Place::kActuator,
                    {Parameter("step", kForce, 0.0, {0.3, 1.5, natural::Force})});
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.thrust = [](const T* p, const EffectSetting&, const T& force, const Instant<T>&) {
      return p[0] == T(0.0) ? force : T(p[0] * std::round(Plain(force) / Plain(p[0])));
    }};
  }
};

// Motors that get warm give less: tau (1 - a H), T dH/dt = |tau| - H.
struct ThrusterHeat {
  static EffectInfo Info() {
    return Unlisted("unlisted.thruster_heat",
                    Place::kActuator,
                    {Parameter("loss", kPerForce, 0.0, {0.1, 0.6, natural::PerForce}),
                     Parameter("time_constant", kDuration, 30.0, {10.0, 60.0, natural::One})});
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.follow = [](const T* p, const T& target, const T& duration, T* state) {
      using std::abs;
      using std::exp;
      const T before = *state;
      *state = abs(target) + (before - abs(target)) * exp(-duration / p[1]);
      return target * (1.0 - p[0] * 0.5 * (before + *state));
    }};
  }
};

// The wash of running thrusters adds drag: f - c |f| v |v|.
struct ThrustWashDrag {
  static EffectInfo Info() {
    return Unlisted("unlisted.thrust_wash_drag",
                    Place::kActuator,
                    {Parameter("coefficient", kWashDrag, 0.0, {0.1, 0.5, natural::WashDrag})});
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.thrust_at_speed = [](const T* p, const T& force, const T& speed) {
      using std::abs;
      return force - p[0] * abs(force) * speed * abs(speed);
    }};
  }
};

// d v sqrt(|v|): between linear and quadratic.
struct PowerDamping {
  static EffectInfo Info() {
    return Unlisted("unlisted.power_damping",
                    Place::kWater,
                    {Parameter("coefficient", kPowerDrag, 0.0, {0.2, 2.0, natural::PowerDrag})});
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      using std::abs;
      using std::sqrt;
      const T& v = water.relative_speed;
      return v == T(0.0) ? T(0.0) : T(p[0] * v * sqrt(abs(v)));
    }};
  }
};

// An obstacle or a jet at one place: F exp(-(x - place)^2 / (2 width^2)) against the motion's axis.
struct PlaceBump {
  static EffectInfo Info() {
    return Unlisted("unlisted.place_bump",
                    Place::kWater,
                    {EitherSign(Parameter("force", kForce, 0.0, {0.2, 1.0, natural::Force, true})),
                     EitherSign(Parameter("place", kLength, 0.0, {0.7, 1.2, natural::Place})),
                     Parameter("width", kLength, 1.0, {0.2, 0.8, natural::Length})});
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      using std::exp;
      const T s = (water.position - p[1]) / p[2];
      return p[0] * exp(-0.5 * s * s);
    }};
  }
};

// A tether that is slack up to `length` and pulls back beyond, on one side only.
struct SlackTether {
  static EffectInfo Info() {
    return Unlisted("unlisted.slack_tether",
                    Place::kWater,
                    {Parameter("stiffness", kStiffness, 0.0, {0.3, 2.0, natural::Stiffness}),
                     EitherSign(Parameter("length", kLength, 0.0, {0.1, 0.8, natural::Length}))});
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      return water.position > p[1] ? T(p[0] * (water.position - p[1])) : T(0.0);
    }};
  }
};

// A current that wanders: the baseline's damping acts on v - c(t), c a random wave.
struct WanderingCurrent {
  static EffectInfo Info() {
    return Unlisted("unlisted.wandering_current",
                    Place::kWater,
                    {Parameter("speed", kSpeed, 0.0, {0.1, 0.6, natural::Speed}),
                     Parameter("correlation_time", kDuration, 20.0, {5.0, 40.0, natural::One}),
                     Parameter("realisation", kRatio, 1.0, {1.0, 1e6, natural::One})});
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>& now) {
      const T current = p[0] * RandomWaveAt(static_cast<std::uint64_t>(Plain(p[2])),
                                            Plain(now.time) / Plain(p[1]));
      return Damping(water, T(water.relative_speed - current)) -
             Damping(water, water.relative_speed);
    }};
  }
  template <typename T>
  static T Damping(const WaterState<T>& water, const T& speed) {
    using std::abs;
    return (water.quadratic_damping * abs(speed) + water.linear_damping) * speed;
  }
};

// A line for each.
const std::vector<Effect>& Effects() {
  static const std::vector<Effect> effects = {
      EffectOf<ThrustBacklash>(),
      EffectOf<ThrustLevels>(),
      EffectOf<ThrusterHeat>(),
      EffectOf<ThrustWashDrag>(),
      EffectOf<PowerDamping>(),
      EffectOf<PlaceBump>(),
      EffectOf<SlackTether>(),
      EffectOf<WanderingCurrent>(),
  };
  return effects;
}

}  // namespace

std::span<const Effect* const> UnlistedEffects() {
  static const std::vector<const Effect*> unlisted = [] {
    std::vector<const Effect*> pointers;
    for (const Effect& effect : Effects()) pointers.push_back(&effect);
    return pointers;
  }();
  return unlisted;
}

const Effect* FindUnlistedEffect(std::string_view name) {
  const auto effects = UnlistedEffects();
  const auto found = std::find_if(effects.begin(), effects.end(), [&](const Effect* effect) {
    return effect->info().name == name;
  });
  return found == effects.end() ? nullptr : *found;
}

}  // namespace fathom
