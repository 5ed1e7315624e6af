// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_simulation.h"

#include "fathom/vehicle/coupled/motion_structure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "plain_simulator.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

const std::vector<Dof> kSix(kAllDofs.begin(), kAllDofs.end());

// A small ROV with couplings, all of them.
CoupledModel Rov() {
  CoupledModel model;
  model.dofs = kSix;
  model.inertia.diagonal() << 40.0, 60.0, 70.0, 2.0, 3.0, 4.0;
  model.inertia(1, 5) = model.inertia(5, 1) = 2.0;
  model.inertia(0, 4) = model.inertia(4, 0) = -1.5;
  model.linear_damping.diagonal() << 5.0, 8.0, 9.0, 0.5, 0.6, 0.8;
  model.linear_damping(1, 5) = 0.7;
  model.linear_damping(5, 1) = -0.4;
  model.quadratic_damping.diagonal() << 30.0, 60.0, 80.0, 1.0, 1.2, 1.5;
  model.offset << 0.3, -0.2, 0.0, 0.01, -0.02, 0.03;
  model.net_buoyancy = 2.0;
  model.righting_roll = 6.0;
  model.righting_pitch = 7.0;
  model.thrust_gain = {{"port", 0.8}};
  model.coriolis = true;
  return model;
}

// Steps of 2 s of two thrusters, beside forces.
CoupledInputs Steps(int num_steps) {
  CoupledInputs inputs;
  CoupledCommand& command = inputs.command;
  command.thrusters = {{"port", Vector6(1.0, 0.1, 0.0, 0.02, 0.0, 0.25), {}},
                       {"starboard", Vector6(1.0, -0.1, 0.05, 0.0, 0.03, -0.25), {}}};
  for (int k = 0; k < num_steps; ++k) {
    command.time.push_back(2.0 * k);
    command.thrusters[0].thrust.push_back(8.0 * std::sin(1.3 * k * k));
    command.thrusters[1].thrust.push_back(8.0 * std::cos(0.7 * k * k));
    Vector6 force = Vector6::Zero();
    force[2] = 6.0 * std::sin(0.9 * k * k);
    force[3] = 1.5 * std::sin(2.1 * k);
    command.force.push_back(force);
  }
  return inputs;
}

Vector6 ForceOf(const CoupledModel& model, const CoupledInputs& inputs, std::size_t row) {
  Vector6 tau = inputs.command.force[row];
  for (const CommandedThruster& thruster : inputs.command.thrusters) {
    const auto gain = model.thrust_gain.find(thruster.name);
    tau += (gain == model.thrust_gain.end() ? 1.0 : gain->second) * thruster.thrust[row] *
           thruster.push;
  }
  return tau;
}

CoupledState Moving() {
  CoupledState start;
  start.nu << 0.3, -0.1, 0.05, 0.1, -0.2, 0.15;
  start.attitude =
      Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, -1).normalized())).coeffs();
  start.position << 1.0, -2.0, 3.0;
  return start;
}

void ExpectASecondSimulatorDoesTheSame(const CoupledModel& model,
                                       const CoupledInputs& inputs,
                                       const Eigen::Vector3d& current = Eigen::Vector3d::Zero()) {
  CoupledStamps stamps;
  for (int k = 0; k < 15; ++k) stamps.velocity.push_back(2.0 * k + 2.0);
  stamps.pose = stamps.velocity;
  CoupledOutputs outputs;
  const CoupledState start = Moving();
  ASSERT_TRUE(RunCoupled(model, inputs, start, stamps, &outputs));

  PlainSimulator plain(model);
  plain.nu = start.nu;
  plain.current = current;
  plain.world_from_body = Eigen::Quaterniond(start.attitude).toRotationMatrix();
  plain.position = start.position;
  for (std::size_t k = 0; k < 15; ++k) {
    plain.Advance(ForceOf(model, inputs, k), 2.0, 2e-4);
    EXPECT_LT((outputs.velocity[k] - plain.nu).norm(), 2e-5) << k;
    const Eigen::Quaterniond attitude(outputs.pose[k].attitude);
    EXPECT_LT((attitude.toRotationMatrix() - plain.world_from_body).norm(), 2e-5) << k;
    EXPECT_LT((outputs.pose[k].position - plain.position).norm(), 2e-5) << k;
  }
}

TEST(RunCoupled, GoesAsASecondSimulatorDoes) {
  ExpectASecondSimulatorDoesTheSame(Rov(), Steps(15));
}

// A friction, drags that are no square, and a wrench that loses some of what is commanded.
CoupledModel RovWithEffects() {
  CoupledModel model = Rov();
  model.effects["coulomb_friction"] << 2.0, 0.0, 1.0, 0.0, 0.0, 0.3;
  model.effects["cubic_damping"] << 30.0, 0.0, 0.0, 1.0, 0.0, 0.0;
  model.effects["damping_asymmetry"] << 0.7, 0.3, 0.0, 0.0, 0.0, 0.4;
  model.effects["thrust_dead_zone"] << 2.0, 1.0, 0.0, 0.0, 0.0, 0.2;
  model.effects["thrust_asymmetry"] << 0.2, 0.0, 0.3, 0.0, 0.0, 0.1;
  return model;
}

TEST(RunCoupled, GoesWithEffectsAsASecondSimulatorDoes) {
  CoupledInputs inputs = Steps(15);
  inputs.command.thrusters.clear();
  ExpectASecondSimulatorDoesTheSame(RovWithEffects(), inputs);
}

TEST(RunCoupled, GoesInACurrentAsASecondSimulatorDoes) {
  CoupledInputs inputs = Steps(15);
  inputs.log = "dive";
  CoupledModel model = Rov();
  model.current = {{"dive", {0.3, -0.2}}, {"another dive", {1.0, 1.0}}};
  ExpectASecondSimulatorDoesTheSame(model, inputs, {0.3, -0.2, 0.0});
}

TEST(RunCoupled, TakesADeadZoneAndTheWeaknessAsternOffEveryThruster) {
  CoupledModel model = Rov();
  model.thruster_effects = {{"thrust_dead_zone", 3.0}, {"thrust_asymmetry", 0.25}};
  const CoupledInputs commanded = Steps(15);
  CoupledInputs left = commanded;
  for (CommandedThruster& thruster : left.command.thrusters) {
    for (double& thrust : thruster.thrust) {
      thrust = thrust > 0.0 ? std::max(thrust - 3.0, 0.0) : 0.75 * std::min(thrust + 3.0, 0.0);
    }
  }
  CoupledStamps stamps;
  for (int k = 1; k < 30; ++k) stamps.velocity.push_back(k);
  CoupledOutputs outputs, by_hand;
  ASSERT_TRUE(RunCoupled(model, commanded, Moving(), stamps, &outputs));
  ASSERT_TRUE(RunCoupled(Rov(), left, Moving(), stamps, &by_hand));
  for (std::size_t k = 0; k < stamps.velocity.size(); ++k) {
    EXPECT_LT((outputs.velocity[k] - by_hand.velocity[k]).norm(), 1e-12) << k;
  }
}

// Outputs between the steps lie on a cubic.
TEST(RunCoupled, ShowsTheSameAtAnyStamps) {
  const CoupledInputs inputs = Steps(5);
  CoupledStamps dense, sparse;
  for (int k = 1; k <= 1000; ++k) dense.velocity.push_back(0.01 * k);
  for (int k = 1; k <= 10; ++k) sparse.velocity.push_back(1.0 * k);
  CoupledOutputs of_dense, of_sparse;
  ASSERT_TRUE(RunCoupled(Rov(), inputs, Moving(), dense, &of_dense));
  ASSERT_TRUE(RunCoupled(Rov(), inputs, Moving(), sparse, &of_sparse));
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_LT((of_dense.velocity[100 * k + 99] - of_sparse.velocity[k]).norm(), 1e-6);
  }
}

// Without water, weight and thrust the momentum stays what it is in the world.
TEST(RunCoupled, KeepsTheMomentumOfABodyThatNothingTouches) {
  CoupledModel model;
  model.dofs = kSix;
  model.inertia.diagonal() << 40.0, 60.0, 70.0, 2.0, 3.0, 4.0;
  model.coriolis = true;
  CoupledStamps stamps;
  for (int k = 1; k <= 20; ++k) stamps.pose.push_back(1.0 * k);
  CoupledOutputs outputs;
  const CoupledState start = Moving();
  ASSERT_TRUE(RunCoupled(model, {}, start, stamps, &outputs));
  const auto momentum = [&](const CoupledState& state) {
    return Eigen::Vector3d(Eigen::Quaterniond(state.attitude) *
                           Eigen::Vector3d((model.inertia * state.nu).head<3>()));
  };
  for (const CoupledState& state : outputs.pose) {
    EXPECT_LT((momentum(state) - momentum(start)).norm(), 1e-4 * momentum(start).norm());
    EXPECT_NEAR(state.nu.dot(model.inertia * state.nu),
                start.nu.dot(model.inertia * start.nu),
                1e-5 * start.nu.dot(model.inertia * start.nu));
  }
}

// b = d_L w + d_Q w^2: a vehicle that nothing drives rises at that speed.
TEST(RunCoupled, RisesAtTheSpeedOfItsBuoyancy) {
  CoupledModel model;
  model.dofs = {Dof::kHeave};
  model.inertia(2, 2) = 70.0;
  model.linear_damping(2, 2) = 9.0;
  model.quadratic_damping(2, 2) = 80.0;
  model.net_buoyancy = 2.0;
  CoupledOutputs outputs;
  CoupledStamps stamps;
  stamps.velocity = {200.0};
  ASSERT_TRUE(RunCoupled(model, {}, {}, stamps, &outputs));
  const double speed = (-9.0 + std::sqrt(81.0 + 4.0 * 80.0 * 2.0)) / (2.0 * 80.0);
  EXPECT_NEAR(outputs.velocity[0][2], -speed, 1e-9);
}

// A small roll swings with sqrt(K / I).
TEST(RunCoupled, SwingsWithTheFrequencyOfAPendulum) {
  CoupledModel model;
  model.dofs = {Dof::kRoll};
  model.inertia(3, 3) = 2.0;
  model.righting_roll = 6.0;
  const double period = 2.0 * std::numbers::pi * std::sqrt(2.0 / 6.0);
  CoupledState start;
  start.nu[3] = 1e-3;
  CoupledOutputs outputs;
  CoupledStamps stamps;
  stamps.velocity = {0.25 * period, 0.5 * period, period};
  ASSERT_TRUE(RunCoupled(model, {}, start, stamps, &outputs));
  EXPECT_NEAR(outputs.velocity[0][3], 0.0, 2e-8);
  EXPECT_NEAR(outputs.velocity[1][3], -1e-3, 2e-8);
  EXPECT_NEAR(outputs.velocity[2][3], 1e-3, 2e-8);
}

TEST(RunCoupled, TakesDofsThatAreNotModelledAsMeasured) {
  CoupledModel model;
  model.dofs = {Dof::kSurge};
  model.inertia.diagonal() << 48.0, 81.0, 1.0, 1.0, 1.0, 16.0;
  model.linear_damping(0, 0) = 145.0;
  model.coriolis = true;
  CoupledInputs inputs;
  inputs.measured[1] = {{0.0, 100.0}, {0.2, 0.2}};
  inputs.measured[5] = {{0.0, 100.0}, {0.5, 0.5}};
  CoupledOutputs outputs;
  CoupledStamps stamps;
  stamps.velocity = {50.0};
  ASSERT_TRUE(RunCoupled(model, inputs, {}, stamps, &outputs));
  EXPECT_NEAR(outputs.velocity[0][0], 81.0 * 0.2 * 0.5 / 145.0, 1e-9);
  EXPECT_EQ(outputs.velocity[0][1], 0.2);
}

// A rudder at the stern behind the port thruster, and a stern plane outside of its race.
Fin Rudder() {
  Fin fin;
  fin.name = "rudder";
  fin.position << -0.6, 0.05, 0.02;
  fin.behind = "port";
  return fin;
}

Fin SternPlane() {
  Fin fin;
  fin.name = "plane";
  fin.position << -0.5, 0.2, 0.0;
  fin.axis = Eigen::Vector3d::UnitY();
  return fin;
}

// No command turns it.
Fin StuckPlane() {
  Fin fin;
  fin.name = "stuck";
  fin.position << -0.5, -0.25, 0.03;
  fin.axis = -Eigen::Vector3d::UnitY();
  return fin;
}

CoupledModel FinnedRov() {
  CoupledModel model = Rov();
  model.lift(1, 1) = 20.0;
  model.lift(1, 5) = -3.0;
  model.lift(5, 1) = 6.0;
  model.fin_force = {{"rudder", 30.0}, {"plane", 25.0}, {"stuck", 20.0}};
  model.fin_race = {{"rudder", 0.04}};
  model.fin_neutral = {{"rudder", 0.03}};
  model.fin_stuck = {{"stuck", 0.15}};
  return model;
}

CoupledInputs FinnedSteps(int num_steps) {
  CoupledInputs inputs = Steps(num_steps);
  CoupledCommand& command = inputs.command;
  command.fins = {{"rudder", ArmsOf(Rudder()), {}, "port"},
                  {"plane", ArmsOf(SternPlane()), {}},
                  {"stuck", ArmsOf(StuckPlane()), {}}};
  for (int k = 0; k < num_steps; ++k) {
    command.fins[0].angle.push_back(0.4 * std::sin(1.1 * k * k));
    command.fins[1].angle.push_back(0.3 * std::cos(1.7 * k));
    command.fins[2].angle.push_back(-0.2 * std::cos(1.3 * k));
  }
  return inputs;
}

// docs/fins.md (3) as the integral of its slope: 1, then down to 0 over a fifth of the limit.
double PlainStalled(double sine, double limit) {
  const double in_bend = std::clamp(std::abs(sine) - 0.9 * limit, 0.0, 0.2 * limit);
  const double size =
      std::min(std::abs(sine), 0.9 * limit) + in_bend * (1.0 - 0.5 * in_bend / (0.2 * limit));
  return std::copysign(size, sine);
}

// docs/fins.md (1) by angles and a rotated normal, and the lift, of a row of FinnedSteps(). All
// fins stall at `stall` [rad].
Vector6 PlainFins(const CoupledInputs& inputs,
                  std::size_t row,
                  const Vector6& nu,
                  std::optional<double> stall = {}) {
  const auto of = [&](const Fin& fin, double f, double angle, double race) {
    const Eigen::Vector3d v = nu.head<3>() + Eigen::Vector3d(nu.tail<3>()).cross(fin.position);
    const Eigen::Vector3d across = fin.axis.cross(Eigen::Vector3d::UnitX());
    const double w = v.dot(across), s = race > 0.0 ? std::sqrt(v.x() * v.x() + race) : v.x();
    double sine = std::sin(angle - std::atan2(w, s));
    if (stall) sine = PlainStalled(sine, std::sin(*stall));
    const double load = f * (s * s + w * w) * sine;
    const Eigen::Vector3d force = load * (Eigen::AngleAxisd(angle, fin.axis) * across);
    Vector6 all;
    all << force, fin.position.cross(force);
    return all;
  };
  const CoupledCommand& command = inputs.command;
  const double thrust = std::max(command.thrusters[0].thrust[row], 0.0);
  Vector6 force = of(Rudder(), 30.0, command.fins[0].angle[row] - 0.03, 0.04 * thrust) +
                  of(SternPlane(), 25.0, command.fins[1].angle[row], 0.0) +
                  of(StuckPlane(), 20.0, 0.15, 0.0);
  force[1] -= nu[0] * (20.0 * nu[1] - 3.0 * nu[5]);
  force[5] -= 6.0 * nu[0] * nu[1];
  return force;
}

TEST(RunCoupled, GoesWithFinsAsASecondSimulatorDoes) {
  const CoupledModel model = FinnedRov();
  const CoupledInputs inputs = FinnedSteps(15);
  CoupledStamps stamps;
  for (int k = 0; k < 15; ++k) stamps.velocity.push_back(2.0 * k + 2.0);
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, Moving(), stamps, &outputs));
  PlainSimulator plain(Rov());
  plain.nu = Moving().nu;
  plain.world_from_body = Eigen::Quaterniond(Moving().attitude).toRotationMatrix();
  for (std::size_t k = 0; k < 15; ++k) {
    plain.more = [&](const Vector6& nu) { return PlainFins(inputs, k, nu); };
    plain.Advance(ForceOf(model, inputs, k), 2.0, 2e-4);
    EXPECT_LT((outputs.velocity[k] - plain.nu).norm(), 5e-5) << k;
  }
}

// The angle that a fin comes to within a time, by a rate.
double Turned(double from, double towards, double most) {
  return from + std::clamp(towards - from, -most, most);
}

TEST(RunCoupled, GoesWithFinsOfALimitedRateAsASecondSimulatorDoes) {
  CoupledModel model = FinnedRov();
  model.fin_rate_limit = {{"rudder", 0.23}, {"plane", 0.4}};
  const CoupledInputs inputs = FinnedSteps(8);
  CoupledStamps stamps;
  for (int k = 0; k < 8; ++k) stamps.velocity.push_back(2.0 * k + 2.0);
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, Moving(), stamps, &outputs));
  PlainSimulator plain(Rov());
  plain.nu = Moving().nu;
  plain.world_from_body = Eigen::Quaterniond(Moving().attitude).toRotationMatrix();
  constexpr double kStep = 5e-4;
  CoupledInputs turned = inputs;
  double rudder = 0.0, plane = 0.0;
  for (std::size_t k = 0; k < 8; ++k) {
    plain.more = [&](const Vector6& nu) { return PlainFins(turned, k, nu); };
    for (int i = 0; i < 4000; ++i) {
      const double to_rudder = inputs.command.fins[0].angle[k];
      const double to_plane = inputs.command.fins[1].angle[k];
      turned.command.fins[0].angle[k] = Turned(rudder, to_rudder, 0.5 * kStep * 0.23);
      turned.command.fins[1].angle[k] = Turned(plane, to_plane, 0.5 * kStep * 0.4);
      rudder = Turned(rudder, to_rudder, kStep * 0.23);
      plane = Turned(plane, to_plane, kStep * 0.4);
      plain.Advance(ForceOf(model, inputs, k), kStep, kStep);
    }
    EXPECT_LT((outputs.velocity[k] - plain.nu).norm(), 5e-5) << k;
  }
}

TEST(RunCoupled, GoesWithFinsThatStallAsASecondSimulatorDoes) {
  CoupledModel model = FinnedRov();
  model.fin_stall = {{"rudder", 0.2}, {"plane", 0.2}, {"stuck", 0.2}};
  const CoupledInputs inputs = FinnedSteps(8);
  CoupledStamps stamps;
  for (int k = 0; k < 8; ++k) stamps.velocity.push_back(2.0 * k + 2.0);
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, Moving(), stamps, &outputs));
  PlainSimulator plain(Rov());
  plain.nu = Moving().nu;
  plain.world_from_body = Eigen::Quaterniond(Moving().attitude).toRotationMatrix();
  for (std::size_t k = 0; k < 8; ++k) {
    plain.more = [&](const Vector6& nu) { return PlainFins(inputs, k, nu, 0.2); };
    plain.Advance(ForceOf(model, inputs, k), 2.0, 2e-4);
    EXPECT_LT((outputs.velocity[k] - plain.nu).norm(), 1e-4) << k;
  }
}

// A light fin below a heavy sled that is towed at 1 m/s, turned to 0.3 rad at 0.2 rad/s from 1 s
// on: m dv/dt = f sin(angle) cos(angle), so that v = f / (4 m r) (1 - cos(2 r t)) on the way, and
// its derivative by r.
TEST(RunCoupled, TurnsAFinAtItsLimitedRate) {
  CoupledModel model;
  model.dofs = {Dof::kSway};
  model.inertia(1, 1) = 2000.0;
  model.fin_force = {{"keel", 1.0}};
  model.fin_rate_limit = {{"keel", 0.2}};
  Fin keel;
  keel.name = "keel";
  CoupledInputs inputs;
  inputs.measured[0] = {{0.0}, {1.0}};
  inputs.command.time = {1.0};
  inputs.command.fins = {{"keel", ArmsOf(keel), {0.3}}};
  CoupledStamps stamps;
  stamps.velocity = {0.9, 1.7, 2.5, 4.0};
  CoupledOutputs outputs;
  const std::vector<FreeEntry> rate = {FinRateLimitEntry("keel")};
  ASSERT_TRUE(RunCoupledWithSensitivities(model, rate, inputs, {}, stamps, &outputs));
  const auto speed = [](double t, double r) {
    const double turns = std::min(t, 0.3 / r);
    const double on_the_way = (1.0 - std::cos(2.0 * r * turns)) / (8000.0 * r);
    return on_the_way + (t - turns) * 0.5 * std::sin(0.6) / 2000.0;
  };
  EXPECT_EQ(outputs.velocity[0][1], 0.0);
  for (std::size_t k = 1; k < 4; ++k) {
    const double t = stamps.velocity[k] - 1.0;
    const double by_rate = (speed(t, 0.2001) - speed(t, 0.1999)) / 0.0002;
    // The fin's own drift is below 1e-3 of the speed that turns it.
    EXPECT_NEAR(outputs.velocity[k][1], speed(t, 0.2), 2e-3 * speed(t, 0.2));
    EXPECT_NEAR(outputs.velocity_sensitivity(6 * static_cast<Eigen::Index>(k) + 1, 0),
                by_rate,
                2e-3 * by_rate);
  }
}

// What was asked for before the start has turned the fin half way.
TEST(RunCoupled, BeginsWhileAFinTurns) {
  CoupledModel model = FinnedRov();
  model.fin_rate_limit = {{"rudder", 0.05}};
  const CoupledInputs inputs = FinnedSteps(5);
  CoupledStamps whole;
  whole.velocity = whole.pose = {4.7, 9.0};
  CoupledOutputs outputs, again;
  ASSERT_TRUE(RunCoupled(model, inputs, Moving(), whole, &outputs));
  CoupledStamps rest;
  rest.start = 4.7;
  rest.velocity = {9.0};
  ASSERT_TRUE(RunCoupled(model, inputs, outputs.pose[0], rest, &again));
  EXPECT_LT((again.velocity[0] - outputs.velocity[1]).norm(), 1e-6);
}

// A shaft off the centre line, of which the model knows 0.7 of the thrust. The rudder stands in its
// race.
Shaft Screw() {
  Shaft shaft;
  shaft.name = "screw";
  shaft.position << -0.5, 0.1, -0.05;
  shaft.diameter = 0.2;
  shaft.curve = OpenWaterCurve{{0.0, 0.5, 0.9}, {0.36, 0.2, 0.0}};
  shaft.wake = 0.3;
  shaft.thrust_deduction = 0.15;
  return shaft;
}

CoupledModel ScrewedRov() {
  CoupledModel model = FinnedRov();
  model.thrust_gain["screw"] = 0.7;
  return model;
}

// Ahead, astern and stopped.
CoupledInputs ScrewedSteps(int num_steps) {
  CoupledInputs inputs = FinnedSteps(num_steps);
  inputs.command.fins[0].behind = "screw";
  inputs.command.shafts = {CommandedShaftOf(Screw())};
  for (int k = 0; k < num_steps; ++k) {
    inputs.command.shafts[0].turns.push_back(k % 4 == 3 ? 0.0 : 2.0 + 4.0 * std::sin(2.3 * k));
  }
  return inputs;
}

// docs/fins.md (2), K_T by J.
double PlainThrust(double n, double u) {
  if (n == 0.0) return 0.0;
  const double J = 0.7 * u / (n * 0.2);
  const double K_T = J < 0.0 ? 0.36 : J < 0.5 ? 0.36 - 0.32 * J : 0.2 - 0.5 * (J - 0.5);
  return 1000.0 * n * std::abs(n) * std::pow(0.2, 4) * K_T;
}

TEST(RunCoupled, GoesWithAShaftAndItsRaceAsASecondSimulatorDoes) {
  const CoupledModel model = ScrewedRov();
  const CoupledInputs inputs = ScrewedSteps(12);
  CoupledStamps stamps;
  for (int k = 0; k < 12; ++k) stamps.velocity.push_back(2.0 * k + 2.0);
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, Moving(), stamps, &outputs));
  PlainSimulator plain(Rov());
  plain.nu = Moving().nu;
  plain.world_from_body = Eigen::Quaterniond(Moving().attitude).toRotationMatrix();
  for (std::size_t k = 0; k < 12; ++k) {
    const double turns = inputs.command.shafts[0].turns[k];
    plain.more = [&](const Vector6& nu) -> Vector6 {
      const Eigen::Vector3d at = Screw().position;
      const double u = (nu.head<3>() + Eigen::Vector3d(nu.tail<3>()).cross(at)).x();
      const double thrust = PlainThrust(turns, u);
      CoupledInputs with_race = inputs;  // PlainFins() takes the race from the first thruster
      with_race.command.thrusters[0].thrust[k] = thrust;
      const Eigen::Vector3d force(0.7 * 0.85 * thrust, 0.0, 0.0);
      Vector6 all;
      all << force, at.cross(force);
      return all + PlainFins(with_race, k, nu);
    };
    plain.Advance(ForceOf(model, inputs, k), 2.0, 5e-4);
    EXPECT_LT((outputs.velocity[k] - plain.nu).norm(), 1e-4) << k;
  }
}

// Terminal speed in closed form: (1 - t) rho D^4 n^2 (K_0 + K_1 (1 - w) u / (n D)) = d u.
TEST(RunCoupled, ReachesTheSpeedAtWhichAShaftAndDampingBalance) {
  CoupledModel model;
  model.dofs = {Dof::kSurge};
  model.inertia(0, 0) = 50.0;
  model.linear_damping(0, 0) = 20.0;
  Shaft shaft = Screw();
  shaft.position.setZero();
  shaft.curve = OpenWaterCurve{{0.0, 0.9}, {0.36, 0.0}};
  CoupledInputs inputs;
  inputs.command.time = {0.0};
  inputs.command.shafts = {CommandedShaftOf(shaft)};
  inputs.command.shafts[0].turns = {6.0};
  CoupledStamps stamps;
  stamps.velocity = {100.0};
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, {}, stamps, &outputs));
  const double at_rest = 0.85 * 1000.0 * 0.0016 * 36.0 * 0.36;
  const double slope = 0.85 * 1000.0 * 0.008 * 6.0 * 0.4 * 0.7;
  EXPECT_NEAR(outputs.velocity[0][0], at_rest / (20.0 + slope), 1e-9);
}

// A ship whose rudder's angle is positive turns to port.
TEST(RunCoupled, TurnsToPortByAPositiveRudder) {
  CoupledModel model = FinnedRov();
  model.fin_neutral = {};
  CoupledInputs inputs;
  inputs.command.time = {0.0};
  inputs.command.fins = {{"rudder", ArmsOf(Rudder()), {0.2}}};
  CoupledState start;
  start.nu[0] = 1.0;
  CoupledStamps stamps;
  stamps.velocity = {1.0};
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, start, stamps, &outputs));
  EXPECT_LT(outputs.velocity[0][5], -0.1);
}

// 0.1 rad to starboard of ahead, along a damping that is the same all round.
TEST(RunCoupled, PushesAlongAThrustThatIsTurned) {
  CoupledModel model;
  model.dofs = {Dof::kSurge, Dof::kSway};
  model.inertia.diagonal().head<2>().setConstant(30.0);
  model.linear_damping.diagonal().head<2>().setConstant(6.0);
  model.thrust_angle = 0.1;
  model.thrust_gain["main"] = 0.5;
  CoupledInputs inputs;
  inputs.command.time = {0.0};
  inputs.command.force = {Vector6::Unit(0)};
  inputs.command.thrusters = {{"main", Vector6::Unit(0), {4.0}}};
  CoupledStamps stamps;
  stamps.velocity = {200.0};
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, {}, stamps, &outputs));
  EXPECT_NEAR(outputs.velocity[0][0], 0.5 * std::cos(0.1), 1e-9);
  EXPECT_NEAR(outputs.velocity[0][1], 0.5 * std::sin(0.1), 1e-9);
}

// 30 kg without damping under 6 N from 1 s on.
CoupledModel Sled() {
  CoupledModel model;
  model.dofs = {Dof::kSurge};
  model.inertia(0, 0) = 30.0;
  return model;
}
CoupledInputs PushFrom1s() {
  CoupledInputs inputs;
  inputs.command.time = {1.0};
  inputs.command.force = {6.0 * Vector6::Unit(0)};
  return inputs;
}

// v = F / m (t - T (1 - exp(-t / T))), and its derivative by T.
TEST(RunCoupled, FollowsItsCommandWithALag) {
  CoupledModel model = Sled();
  model.thruster_lag = 0.4;
  CoupledStamps stamps;
  stamps.velocity = {1.1, 1.5, 4.0};
  CoupledOutputs outputs;
  const std::vector<FreeEntry> lag = {ThrusterLagEntry()};
  ASSERT_TRUE(RunCoupledWithSensitivities(model, lag, PushFrom1s(), {}, stamps, &outputs));
  for (std::size_t k = 0; k < 3; ++k) {
    const double t = stamps.velocity[k] - 1.0, gone = std::exp(-t / 0.4);
    EXPECT_NEAR(outputs.velocity[k][0], 0.2 * (t - 0.4 * (1.0 - gone)), 1e-6);
    EXPECT_NEAR(outputs.velocity_sensitivity(6 * static_cast<Eigen::Index>(k), 0),
                -0.2 * (1.0 - gone - t / 0.4 * gone),
                1e-5);
  }
}

// What was asked for before the start is on its way.
TEST(RunCoupled, BeginsWithinALag) {
  CoupledModel model = Sled();
  model.thruster_lag = 0.4;
  CoupledStamps stamps = {1.2, {3.0}, {}};
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, PushFrom1s(), {}, stamps, &outputs));
  EXPECT_NEAR(outputs.velocity[0][0],
              0.2 * (1.8 - 0.4 * (std::exp(-0.2 / 0.4) - std::exp(-2.0 / 0.4))),
              1e-6);
}

// A lag of 0 s and an offset lose alike: the force over the inertia, a second.
TEST(RunCoupled, LosesAtOnceByALagThatBegins) {
  CoupledStamps stamps;
  stamps.velocity = {0.9, 1.5};
  CoupledOutputs outputs;
  const std::vector<FreeEntry> entries = {ThrusterLagEntry(), TimeOffsetEntry()};
  ASSERT_TRUE(RunCoupledWithSensitivities(Sled(), entries, PushFrom1s(), {}, stamps, &outputs));
  for (Eigen::Index column = 0; column < 2; ++column) {
    EXPECT_EQ(outputs.velocity_sensitivity(0, column), 0.0);
    EXPECT_NEAR(outputs.velocity_sensitivity(6, column), -0.2, 1e-12);
  }
}

TEST(RunCoupled, TakesItsCommandLateByAnOffset) {
  CoupledModel late = FinnedRov();
  late.time_offset = 0.37;
  CoupledInputs shifted = FinnedSteps(5);
  for (double& t : shifted.command.time) t += 0.37;
  CoupledStamps stamps;
  stamps.velocity = {2.0, 9.0};
  CoupledOutputs outputs, expected;
  ASSERT_TRUE(RunCoupled(late, FinnedSteps(5), Moving(), stamps, &outputs));
  ASSERT_TRUE(RunCoupled(FinnedRov(), shifted, Moving(), stamps, &expected));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT((outputs.velocity[k] - expected.velocity[k]).norm(), 1e-9);
  }
}

TEST(RunCoupled, RefusesAnInertiaThatIsNone) {
  CoupledModel model = Rov();
  model.inertia(1, 5) = model.inertia(5, 1) = 20.0;
  CoupledOutputs outputs;
  EXPECT_FALSE(RunCoupled(model, {}, {}, {}, &outputs));
}

// Each column of the sensitivities against the difference of two runs.
void ExpectDerivativesOfDifferences(const CoupledModel& model, const CoupledInputs& inputs) {
  MotionStructure structure = StructureOf(StandardStructure::kFull, kSix);
  structure.entries.push_back(QuadraticDampingEntry(Dof::kYaw, Dof::kSway));
  structure.entries.push_back(ThrustGainEntry("port"));
  structure.entries.push_back(ThrustAngleEntry());
  if (!inputs.command.shafts.empty()) structure.entries.push_back(ThrustGainEntry("screw"));
  structure.entries.push_back(LiftEntry(Dof::kSway, Dof::kYaw));
  structure.entries.push_back(FinForceEntry("plane"));
  structure.entries.push_back(FinRaceEntry("rudder"));
  structure.entries.push_back(FinNeutralEntry("rudder"));
  structure.entries.push_back(FinStuckEntry("stuck"));
  // An offset moves the steps, whose errors where the slope of a stall bends its differences would
  // hold; in steps of 2 ms they agree.
  if (model.fin_stall.empty()) structure.entries.push_back(TimeOffsetEntry());
  if (model.thruster_lag > 0.0) structure.entries.push_back(ThrusterLagEntry());
  for (const auto& [fin, lag] : model.fin_lag) structure.entries.push_back(FinLagEntry(fin));
  for (const FreeEntry& entry : EntriesIn(model)) {
    if (IsEffect(entry) || IsLimit(entry) || IsOfRun(entry)) structure.entries.push_back(entry);
  }
  CoupledStamps stamps;
  stamps.start = 0.1;  // at no change of the command, which an offset moves in or out
  for (int k = 1; k <= 20; ++k) stamps.velocity.push_back(0.47 * k);
  stamps.pose = stamps.velocity;
  CoupledOutputs outputs;
  const CoupledState start = Moving();
  ASSERT_TRUE(
      RunCoupledWithSensitivities(model, structure.entries, inputs, start, stamps, &outputs));
  const int columns = NumCoupledColumns(model, structure.entries);
  ASSERT_EQ(outputs.velocity_sensitivity.cols(), columns);

  for (int column = 0; column < columns; ++column) {
    const auto run = [&](double by) {
      CoupledModel moved = model;
      CoupledState from = start;
      const int num_entries = static_cast<int>(structure.entries.size());
      if (column < num_entries) {
        const FreeEntry& entry = structure.entries[static_cast<std::size_t>(column)];
        SetValue(entry, ValueIn(model, entry) + by, &moved);
      } else if (column < num_entries + 6) {
        from.nu[column - num_entries] += by;
      } else {
        const Eigen::Vector3d turn = by * Eigen::Vector3d::Unit(column - num_entries - 6);
        const Eigen::Quaterniond by_turn(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
        from.attitude = (Eigen::Quaterniond(start.attitude) * by_turn).coeffs();
      }
      CoupledOutputs moved_outputs;
      EXPECT_TRUE(RunCoupled(moved, inputs, from, stamps, &moved_outputs));
      return moved_outputs;
    };
    const std::string name = column < static_cast<int>(structure.entries.size())
                                 ? NameOf(structure.entries[static_cast<std::size_t>(column)])
                                 : std::to_string(column);
    // An offset and a limited rate move the steps of integration too, whose errors their
    // differences hold.
    const bool is_offset = name == "time_offset", is_rate = name.starts_with("fin_rate_limit");
    const double kStep = is_offset ? 4e-3 : is_rate ? 2e-3 : 1e-5;
    const double kClose = is_offset || is_rate ? 5e-4 : 1e-4;
    const CoupledOutputs above = run(kStep), below = run(-kStep);
    for (std::size_t k = 0; k < stamps.velocity.size(); ++k) {
      const auto row = 6 * static_cast<Eigen::Index>(k);
      const Vector6 velocity = (above.velocity[k] - below.velocity[k]) / (2.0 * kStep);
      const Vector6 of_velocity = outputs.velocity_sensitivity.block<6, 1>(row, column);
      EXPECT_LT((of_velocity - velocity).norm(), kClose * (1.0 + velocity.norm())) << name;
      const Eigen::Vector3d position =
          (above.pose[k].position - below.pose[k].position) / (2.0 * kStep);
      const Eigen::Vector3d of_position = outputs.pose_sensitivity.block<3, 1>(row + 3, column);
      EXPECT_LT((of_position - position).norm(), kClose * (1.0 + position.norm())) << name;
      const Eigen::Quaterniond between = Eigen::Quaterniond(below.pose[k].attitude).conjugate() *
                                         Eigen::Quaterniond(above.pose[k].attitude);
      const Eigen::Vector3d turn = 2.0 * between.vec() / between.w() / (2.0 * kStep);
      const Eigen::Vector3d of_turn = outputs.pose_sensitivity.block<3, 1>(row, column);
      EXPECT_LT((of_turn - turn).norm(), kClose * (1.0 + turn.norm())) << name;
    }
  }
}

TEST(RunCoupledWithSensitivities, HasTheDerivativesOfDifferences) {
  CoupledModel turned = FinnedRov();
  turned.thrust_angle = 0.2;
  ExpectDerivativesOfDifferences(turned, FinnedSteps(5));
}

TEST(RunCoupledWithSensitivities, HasThemWithLags) {
  CoupledModel lagged = FinnedRov();
  lagged.thruster_lag = 0.3;
  lagged.fin_lag = {{"rudder", 0.6}};
  ExpectDerivativesOfDifferences(lagged, FinnedSteps(5));
}

TEST(RunCoupledWithSensitivities, HasThemInACurrent) {
  CoupledInputs inputs = FinnedSteps(5);
  inputs.log = "dive";
  CoupledModel model = FinnedRov();
  model.current = {{"dive", {0.3, -0.2}}};
  ExpectDerivativesOfDifferences(model, inputs);
}

// One that turns all the time, and one that arrives.
TEST(RunCoupledWithSensitivities, HasThemWithLimitedRates) {
  CoupledModel limited = FinnedRov();
  limited.fin_rate_limit = {{"rudder", 0.17}, {"plane", 0.6}};
  ExpectDerivativesOfDifferences(limited, FinnedSteps(5));
}

TEST(RunCoupledWithSensitivities, HasThemWithStall) {
  CoupledModel stalled = FinnedRov();
  stalled.fin_stall = {{"rudder", 0.3}, {"plane", 0.2}, {"stuck", 0.15}};
  ExpectDerivativesOfDifferences(stalled, FinnedSteps(5));
}

TEST(RunCoupledWithSensitivities, HasThemWithEffects) {
  CoupledModel model = FinnedRov();
  model.effects = RovWithEffects().effects;
  // Differences would show the errors of the steps at the kink of a large one.
  model.effects["coulomb_friction"] *= 0.02;
  model.thruster_effects = {{"thrust_dead_zone", 1.0}, {"thrust_asymmetry", 0.25}};
  model.thruster_lag = 0.3;
  ExpectDerivativesOfDifferences(model, FinnedSteps(5));
}

// By the thrust's slope in the speed, and that of the race over the rudder.
TEST(RunCoupledWithSensitivities, HasThemWithAShaft) {
  ExpectDerivativesOfDifferences(ScrewedRov(), ScrewedSteps(5));
}

}  // namespace
}  // namespace fathom
