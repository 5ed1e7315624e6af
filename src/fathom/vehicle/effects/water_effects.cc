// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effects/water_effects.h"

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

struct DampingAsymmetry {
  static EffectInfo Info() {
    return {.name = "damping_asymmetry",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters =
                {{.name = "ratio", .quantity = kRatio, .null = 0.0, .lower = -1.0, .upper = 20.0}},
            .cause = "the hull has more drag one way than the other",
            .advice = "Use a quadratic damping for each direction."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>& water,
                      const Instant<T>&) {
    const T& v = water.relative_speed;
    return v < T(0.0) ? T(-p[0] * water.quadratic_damping * v * v) : T(0.0);
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
                            .upper = kInfinity}},
            .cause = "drag grows faster with speed than linear and quadratic damping say",
            .advice = "Use the model only at the speeds of this log, or keep the cubic term."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>& water,
                      const Instant<T>&) {
    const T& v = water.relative_speed;
    return p[0] * v * v * v;
  }
};

struct CoulombFriction {
  static EffectInfo Info() {
    return {
        .name = "coulomb_friction",
        .place = Place::kWater,
        .scope = Scope::kVehicle,
        .parameters =
            {{.name = "force", .quantity = kForce, .null = 0.0, .lower = 0.0, .upper = kInfinity}},
        .cause = "something rubs: a tether, a guide rail",
        .advice = "Look at what the tether or the rail touches."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>& water,
                      const Instant<T>&) {
    using std::tanh;
    constexpr double kSlowest = 0.005;  // [m/s] or [rad/s]
    return p[0] * tanh(water.speed / kSlowest);
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
                            .upper = kInfinity}},
            .cause = "the water itself moved",
            .advice =
                "Repeat the run on the opposite heading: a current changes sign, a bias does "
                "not."};
  }
  template <typename T>
  static T RelativeSpeed(const T* p, const T& speed) {
    return speed - p[0];
  }
};

struct PositionStiffness {
  static EffectInfo Info() {
    return {.name = "position_stiffness",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "stiffness",
                            .quantity = kStiffness,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity}},
            .cause =
                "a force grows with the distance: a tether's pull, buoyancy that changes with "
                "depth, a restoring moment",
            .advice = "Give the tether slack, or keep the spring in the model."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>& water,
                      const Instant<T>&) {
    return p[0] * water.position;
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
                            .upper = kInfinity},
                           {.name = "time",
                            .quantity = kDuration,
                            .null = kAny,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kTimeOfRun}},
            .cause = "a constant force changed from one moment to the next",
            .advice = "Look for a payload dropped, water taken in or a snag at that time."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>&,
                      const Instant<T>& now) {
    return p[0] * SwitchedOn(T(now.time - p[1]));
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
                            .trials = {1e-4}}},
            .cause = "a constant force drifted over the run",
            .advice = "Look for slow ingress of water, or foam that warms or is compressed."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>&,
                      const Instant<T>& now) {
    return p[0] * now.time;
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
                            .upper = kInfinity},
                           {.name = "cosine",
                            .quantity = kForce,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity},
                           {.name = "frequency",
                            .quantity = kFrequency,
                            .null = kAny,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .search = Search::kFrequencyOfRun}},
            .cause =
                "a force came and went at one frequency: waves, a slapping tether, another "
                "DOF's controller in a limit cycle",
            .advice = "Look for what else has that period."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>&,
                      const Instant<T>& now) {
    using std::cos;
    using std::sin;
    const T phase = p[2] * now.time;
    return -(p[0] * sin(phase) + p[1] * cos(phase));
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
                            .upper = kInfinity},
                           {.name = "time_constant",
                            .quantity = kDuration,
                            .null = kAny,
                            .lower = 0.3,
                            .upper = 100.0,
                            .search = Search::kShape,
                            .trials = {0.6, 1.5, 4.0, 10.0, 25.0}}},
            .cause = "the wake lags the motion",
            .advice = "Keep the memory term for manoeuvres as quick as its time constant."};
  }
  template <typename T>
  static T MemoryRate(const T* p, const T& memory, const T& speed) {
    return (speed - memory) / p[1];
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>& water,
                      const Instant<T>&) {
    return p[0] * (water.speed - water.memory);
  }
};

struct CoriolisCoupling {
  static EffectInfo Info() {
    return {.name = "coriolis_coupling",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "coefficient",
                            .quantity = kMass,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity}},
            .has_partner = true,
            .cause = "turning while moving pushes the vehicle sideways",
            .advice = "Use a model of coupled DOFs, or identify without turning."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>&,
                      const Instant<T>& now) {
    return p[0] * now.partner.velocity * now.partner.yaw_rate;
  }
};

struct VelocityCoupling {
  static EffectInfo Info() {
    return {.name = "velocity_coupling",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "coefficient",
                            .quantity = kLinearDrag,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity}},
            .has_partner = true,
            .cause = "motion along another DOF drags this one along",
            .advice = "Add the damping between the two DOFs to the model."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>&,
                      const Instant<T>& now) {
    return p[0] * now.partner.velocity;
  }
};

struct ThrustCrosstalk {
  static EffectInfo Info() {
    return {.name = "thrust_crosstalk",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "gain",
                            .quantity = kRatio,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity}},
            .has_partner = true,
            .cause = "another DOF's command pushes this one too",
            .advice = "Check the thrusters' directions and the allocation."};
  }
  template <typename T>
  static T Resistance(const T* p,
                      const EffectSetting&,
                      const WaterState<T>&,
                      const Instant<T>& now) {
    return -p[0] * now.partner.force;
  }
};

}  // namespace

std::span<const Effect* const> WaterEffects() {
  static const EffectOf<DampingAsymmetry> damping_asymmetry;
  static const EffectOf<CubicDamping> cubic_damping;
  static const EffectOf<CoulombFriction> coulomb_friction;
  static const EffectOf<SteadyCurrent> steady_current;
  static const EffectOf<PositionStiffness> position_stiffness;
  static const EffectOf<BuoyancyStep> buoyancy_step;
  static const EffectOf<BuoyancyDrift> buoyancy_drift;
  static const EffectOf<PeriodicForce> periodic_force;
  static const EffectOf<FluidMemory> fluid_memory;
  static const EffectOf<CoriolisCoupling> coriolis_coupling;
  static const EffectOf<VelocityCoupling> velocity_coupling;
  static const EffectOf<ThrustCrosstalk> thrust_crosstalk;
  static const std::array<const Effect*, 12> effects = {&damping_asymmetry,
                                                        &cubic_damping,
                                                        &coulomb_friction,
                                                        &steady_current,
                                                        &position_stiffness,
                                                        &buoyancy_step,
                                                        &buoyancy_drift,
                                                        &periodic_force,
                                                        &fluid_memory,
                                                        &coriolis_coupling,
                                                        &velocity_coupling,
                                                        &thrust_crosstalk};
  return effects;
}

}  // namespace fathom
