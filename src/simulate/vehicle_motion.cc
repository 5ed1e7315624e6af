// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/vehicle_motion.h"

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

// state + factor * slope
MotionState Moved(const MotionState& state, double factor, const MotionState& slope) {
  MotionState moved;
  moved.velocity = state.velocity + factor * slope.velocity;
  moved.travel = state.travel + factor * slope.travel;
  moved.body_in_world = state.body_in_world + factor * slope.body_in_world;
  moved.world_from_body = state.world_from_body + factor * slope.world_from_body;
  return moved;
}

// One step of the classical scheme, docs/models.md.
template <typename Slope>
MotionState RungeKuttaStep(const MotionState& state, double step, const Slope& slope) {
  const MotionState k1 = slope(state);
  const MotionState k2 = slope(Moved(state, 0.5 * step, k1));
  const MotionState k3 = slope(Moved(state, 0.5 * step, k2));
  const MotionState k4 = slope(Moved(state, step, k3));
  MotionState next = Moved(state, step / 6.0, k1);
  next = Moved(next, step / 3.0, k2);
  next = Moved(next, step / 3.0, k3);
  next = Moved(next, step / 6.0, k4);
  next.world_from_body.normalize();
  return next;
}

}  // namespace

VehicleMotion::VehicleMotion(const Vehicle& vehicle, const std::vector<Dof>& driven)
    : vehicle_name_(vehicle.name), driven_(driven) {
  for (const Dof dof : driven) {
    CHECK(vehicle.models[Index(dof)]) << Name(dof);
    models_[Index(dof)] = *vehicle.models[Index(dof)];
  }
}

MotionState VehicleMotion::After(const MotionState& state,
                                 const std::array<double, 6>& force,
                                 double duration) const {
  const auto slope = [&](const MotionState& now) {
    MotionState rate;
    for (const Dof dof : driven_) {
      const int i = Index(dof);
      rate.velocity[i] = models_[i].Acceleration(now.velocity[i], force[i]);
    }
    rate.travel = now.velocity;
    const Eigen::Map<const Eigen::Quaterniond> world_from_body(now.world_from_body.data());
    rate.body_in_world =
        world_from_body.toRotationMatrix() * Eigen::Vector3d(now.velocity.head<3>());
    const Eigen::Quaterniond turn(
        0.0, 0.5 * now.velocity[3], 0.5 * now.velocity[4], 0.5 * now.velocity[5]);
    rate.world_from_body = (world_from_body * turn).coeffs();
    return rate;
  };
  const auto longest_step = [&](const MotionState& now) {
    double step = kLongestStep;
    for (const Dof dof : driven_) {
      const auto& model = models_[Index(dof)];
      const double speed = std::abs(now.velocity[Index(dof)]);
      const double damping = model.linear_damping + 2.0 * model.quadratic_damping * speed;
      step = std::min(step, 0.05 * model.inertia / damping);  // inf if there is no damping
    }
    return step;
  };

  MotionState now = state;
  double left = duration;
  while (left > 0.0) {
    const double step = longest_step(now);
    if (!(step >= kShortestStep)) {
      throw InputError(
          fmt::format("vehicle '{}': moves too fast or is damped too strongly to be integrated "
                      "(a step of {:.2g} s would be needed). Check the units of its models and of "
                      "the experiment's forces.",
                      vehicle_name_,
                      step));
    }
    const double num_steps = std::ceil(left / step);
    now = RungeKuttaStep(now, left / num_steps, slope);
    left = num_steps <= 1.0 ? 0.0 : left - left / num_steps;
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
