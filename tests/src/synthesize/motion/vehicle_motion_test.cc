// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/motion/vehicle_motion.h"

#include "fathom/base/input_error.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

Vehicle VehicleOf(Dof dof, const UncoupledModel<double>& model) {
  Vehicle vehicle;
  vehicle.name = "probe";
  vehicle.models[Index(dof)] = model;
  return vehicle;
}

TEST(VehicleMotion, ComesToRestExponentiallyUnderLinearDamping) {
  const VehicleMotion motion(VehicleOf(Dof::kSway, {12.0, 0.0, 3.0, -1.5}), {Dof::kSway});
  MotionState state;
  state.velocity[1] = 0.7;
  state = motion.After(state, Undelayed({0.0, 2.4, 0.0, 0.0, 0.0, 0.0}), 0.0, 5.3);
  // v = v_end + (v0 - v_end) exp(-t / T), T = 4, v_end = (2.4 + 1.5) / 3; x its integral.
  const double v_end = 1.3, decay = std::exp(-5.3 / 4.0);
  const double travel = v_end * 5.3 + (0.7 - v_end) * 4.0 * (1.0 - decay);
  // Steps of 5 ms: (h / T)^4 is 2e-12.
  EXPECT_NEAR(state.velocity[1], v_end + (0.7 - v_end) * decay, 1e-11);
  EXPECT_NEAR(state.travel[1], travel, 1e-11);
  EXPECT_NEAR(state.body_in_world.y(), travel, 1e-11);
  EXPECT_EQ(state.body_in_world.x(), 0.0);
  EXPECT_EQ(state.velocity[0], 0.0);
}

TEST(VehicleMotion, SlowsDownHyperbolicallyUnderQuadraticDamping) {
  const VehicleMotion motion(VehicleOf(Dof::kHeave, {12.0, 7.0, 0.0, 0.0}), {Dof::kHeave});
  for (const double sign : {1.0, -1.0}) {
    MotionState state;
    state.velocity[2] = sign * 0.9;
    state = motion.After(state, {}, 0.0, 8.0);
    // 1/v = 1/v0 + d_Q t / m, x = m / d_Q log(1 + v0 d_Q t / m).
    const double factor = 1.0 + 0.9 * 7.0 * 8.0 / 12.0;
    EXPECT_NEAR(state.velocity[2], sign * 0.9 / factor, 1e-11);
    EXPECT_NEAR(state.body_in_world.z(), sign * 12.0 / 7.0 * std::log(factor), 1e-11);
  }
}

TEST(VehicleMotion, RunsACircleWhenItTurnsWhileItMovesAhead) {
  Vehicle vehicle = VehicleOf(Dof::kSurge, {12.0, 0.0, 0.0, 0.0});
  vehicle.models[Index(Dof::kYaw)] = {4.0, 0.0, 0.0, 0.0};
  const VehicleMotion motion(vehicle, {Dof::kSurge, Dof::kYaw});
  MotionState state;
  state.velocity[0] = 0.8;
  state.velocity[5] = 0.5;
  const double t = 7.0;
  state = motion.After(state, {}, 0.0, t);
  // To starboard for a positive yaw rate: z points down.
  EXPECT_NEAR(state.body_in_world.x(), 0.8 / 0.5 * std::sin(0.5 * t), 1e-11);
  EXPECT_NEAR(state.body_in_world.y(), 0.8 / 0.5 * (1.0 - std::cos(0.5 * t)), 1e-11);
  EXPECT_NEAR(state.world_from_body[2], std::sin(0.25 * t), 1e-11);
  EXPECT_NEAR(state.world_from_body[3], std::cos(0.25 * t), 1e-11);
}

TEST(VehicleMotion, TurnsAboutTheBodysAxes) {
  Vehicle vehicle = VehicleOf(Dof::kRoll, {2.0, 0.0, 0.0, 0.0});
  vehicle.models[Index(Dof::kPitch)] = {3.0, 0.0, 0.0, 0.0};
  const VehicleMotion motion(vehicle, {Dof::kRoll, Dof::kPitch});
  MotionState state;
  state.world_from_body =
      Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ())).coeffs();
  state.velocity[3] = 0.3;
  state.velocity[4] = -0.7;
  const Eigen::Vector3d omega(0.3, -0.7, 0.0);
  const Eigen::Quaterniond expected =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(omega.norm() * 2.0, omega.normalized());  // constant rate: one rotation
  state = motion.After(state, {}, 0.0, 2.0);
  EXPECT_LT(expected.angularDistance(Eigen::Quaterniond(state.world_from_body)), 1e-7);
}

TEST(VehicleMotion, RefusesWhatCannotBeIntegrated) {
  const VehicleMotion stiff(VehicleOf(Dof::kSurge, {1e-3, 0.0, 1e3, 0.0}), {Dof::kSurge});
  EXPECT_THROW(stiff.After({}, {}, 0.0, 1.0), InputError);
  const VehicleMotion light(VehicleOf(Dof::kSurge, {1e-300, 0.0, 0.0, 0.0}), {Dof::kSurge});
  EXPECT_THROW(light.After({}, Undelayed({1e300, 0.0, 0.0, 0.0, 0.0, 0.0}), 0.0, 1.0), InputError);
}

}  // namespace
}  // namespace fathom
