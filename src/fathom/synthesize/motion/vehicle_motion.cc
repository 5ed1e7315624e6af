// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/motion/vehicle_motion.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kLongestStep = 5e-3;   // [s]
constexpr double kShortestStep = 1e-5;  // [s]
constexpr double kProbe = 1e-4;         // of speed [m/s] or [rad/s]

// state + factor * slope
MotionState Moved(const MotionState& state, double factor, const MotionState& slope) {
  MotionState moved;
  moved.velocity = state.velocity + factor * slope.velocity;
  moved.travel = state.travel + factor * slope.travel;
  moved.body_in_world = state.body_in_world + factor * slope.body_in_world;
  moved.world_from_body = state.world_from_body + factor * slope.world_from_body;
  moved.thrust = state.thrust;
  moved.memory = state.memory + factor * slope.memory;
  return moved;
}

// One step of the classical scheme, docs/models.md; slope(state, seconds since the step's begin).
template <typename Slope>
MotionState RungeKuttaStep(const MotionState& state, double step, const Slope& slope) {
  const MotionState k1 = slope(state, 0.0);
  const MotionState k2 = slope(Moved(state, 0.5 * step, k1), 0.5 * step);
  const MotionState k3 = slope(Moved(state, 0.5 * step, k2), 0.5 * step);
  const MotionState k4 = slope(Moved(state, step, k3), step);
  MotionState next = Moved(state, step / 6.0, k1);
  next = Moved(next, step / 3.0, k2);
  next = Moved(next, step / 3.0, k3);
  next = Moved(next, step / 6.0, k4);
  next.world_from_body.normalize();
  return next;
}

}  // namespace

VehicleMotion::VehicleMotion(const Vehicle& vehicle,
                             const std::vector<Dof>& driven,
                             std::span<const ActiveEffect> effects,
                             const std::array<Turbulence, 6>& turbulence)
    : vehicle_name_(vehicle.name), driven_(driven), turbulence_(turbulence) {
  for (const Dof dof : driven) {
    CHECK(vehicle.models[Index(dof)]) << Name(dof);
    models_[Index(dof)] = *vehicle.models[Index(dof)];
    hidden_[Index(dof)] = HiddenIn(dof, effects);
    first_effect_[Index(dof)] = num_effects_;
    num_effects_ += static_cast<int>(hidden_[Index(dof)].size());
  }
  CHECK_EQ(static_cast<std::size_t>(num_effects_), effects.size());
  CHECK_LE(num_effects_, EffectStates::MaxRowsAtCompileTime);
}

MotionState VehicleMotion::Start(const std::array<double, 6>& speed) const {
  MotionState state;
  state.thrust.setZero(num_effects_);
  state.memory.setZero(num_effects_);
  for (const Dof dof : driven_) {
    const int i = Index(dof);
    state.velocity[i] = speed[i];
    state.memory.segment(first_effect_[i], static_cast<Eigen::Index>(hidden_[i].size()))
        .setConstant(speed[i]);
  }
  return state;
}

double VehicleMotion::Acceleration(Dof dof,
                                   double speed,
                                   const MotionState& now,
                                   const HeldForces& held,
                                   double force,
                                   double time) const {
  const int i = Index(dof);
  const HiddenEffects& hidden = hidden_[i];
  const double random_force = turbulence_[i].empty() ? 0.0 : turbulence_[i].At(time);
  if (hidden.empty()) return models_[i].Acceleration(speed, force + random_force);
  const double relative_speed = hidden.RelativeSpeed(speed);
  WaterState<double> water = {speed,
                              relative_speed,
                              now.travel[i],
                              0.0,
                              models_[i].quadratic_damping,
                              models_[i].linear_damping};
  const Surroundings surroundings = {time, now.velocity, held.sent};
  const double resistance = hidden.Resistance(
      &water, now.memory.data() + first_effect_[i], InstantsOf(hidden, surroundings));
  return models_[i].Acceleration(relative_speed,
                                 hidden.ForceAtSpeed(force, speed) - resistance + random_force);
}

MotionState VehicleMotion::Slope(const MotionState& now,
                                 const HeldForces& held,
                                 const std::array<double, 6>& force,
                                 double time) const {
  MotionState rate;
  rate.memory.setZero(num_effects_);
  for (const Dof dof : driven_) {
    const int i = Index(dof);
    rate.velocity[i] = Acceleration(dof, now.velocity[i], now, held, force[i], time);
    hidden_[i].MemoryRates(now.memory.data() + first_effect_[i],
                           now.velocity[i],
                           rate.memory.data() + first_effect_[i]);
  }
  rate.travel = now.velocity;
  const Eigen::Map<const Eigen::Quaterniond> world_from_body(now.world_from_body.data());
  rate.body_in_world = world_from_body.toRotationMatrix() * Eigen::Vector3d(now.velocity.head<3>());
  const Eigen::Quaterniond turn(
      0.0, 0.5 * now.velocity[3], 0.5 * now.velocity[4], 0.5 * now.velocity[5]);
  rate.world_from_body = (world_from_body * turn).coeffs();
  return rate;
}

double VehicleMotion::LongestStep(const MotionState& now,
                                  const HeldForces& held,
                                  double time) const {
  double step = kLongestStep;
  for (const Dof dof : driven_) {
    const int i = Index(dof);
    const auto& model = models_[i];
    const double speed = hidden_[i].RelativeSpeed(now.velocity[i]);
    const double damping = model.linear_damping + 2.0 * model.quadratic_damping * std::abs(speed);
    step = std::min(step, 0.05 * model.inertia / damping);  // inf if there is no damping
    if (hidden_[i].empty()) continue;
    // What effects add, by differences: at this speed, and at rest, where friction turns.
    for (const double at : {now.velocity[i], 0.0}) {
      const auto acceleration = [&](double v) {
        return Acceleration(dof, v, now, held, held.arrived[i], time);
      };
      const double rate = (acceleration(at + kProbe) - acceleration(at - kProbe)) / (2.0 * kProbe);
      step = std::min(step, 0.05 / std::abs(rate));
    }
  }
  return step;
}

MotionState VehicleMotion::After(const MotionState& state,
                                 const HeldForces& held,
                                 double start,
                                 double duration) const {
  MotionState now = state;
  double left = duration;
  while (left > 0.0) {
    const double time = start + (duration - left);
    const double longest = LongestStep(now, held, time);
    if (!(longest >= kShortestStep)) {
      throw InputError(
          fmt::format("vehicle '{}': moves too fast or is damped too strongly to be integrated "
                      "(a step of {:.2g} s would be needed). Check the units of its models and of "
                      "the experiment's forces.",
                      vehicle_name_,
                      longest));
    }
    const double num_steps = std::ceil(left / longest);
    const double step = left / num_steps;
    std::array<double, 6> force = held.arrived;
    for (const Dof dof : driven_) {
      const int i = Index(dof);
      const Surroundings surroundings = {time + 0.5 * step, now.velocity, held.sent};
      force[i] = hidden_[i].MeanForce(force[i],
                                      step,
                                      InstantsOf(hidden_[i], surroundings),
                                      now.thrust.data() + first_effect_[i]);
    }
    now = RungeKuttaStep(now, step, [&](const MotionState& at, double since) {
      return Slope(at, held, force, time + since);
    });
    left = num_steps <= 1.0 ? 0.0 : left - step;
  }
  if (!now.velocity.allFinite() || !now.body_in_world.allFinite()) {
    throw InputError(
        fmt::format("vehicle '{}': its speed leaves the finite numbers. Check the units of its "
                    "models and of the experiment's forces.",
                    vehicle_name_));
  }
  return now;
}

}  // namespace fathom
