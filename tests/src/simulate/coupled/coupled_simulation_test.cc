// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_simulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "plain_simulator.h"
#include "test_rov.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

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

// A step is at most a quarter of the quickest time constant: the scheme's error is then some 1e-5
// of what changes.
TEST(RunCoupled, GoesTheSameInTheLongestStepsThatTheModelAllows) {
  CoupledStamps stamps;
  for (int k = 1; k <= 40; ++k) stamps.velocity.push_back(0.25 * k);
  CoupledOutputs of_short, of_long;
  ASSERT_TRUE(RunCoupled(Rov(), Steps(5), Moving(), stamps, &of_short));
  ASSERT_TRUE(RunCoupled(Rov(), Steps(5), Moving(), stamps, &of_long, {.longest = 10.0}));
  EXPECT_LT(of_long.num_steps, of_short.num_steps);
  for (std::size_t k = 0; k < stamps.velocity.size(); ++k) {
    EXPECT_LT((of_long.velocity[k] - of_short.velocity[k]).norm(), 1e-4);
  }
}

// Without water, weight and thrust the momentum stays what it is in the world.
TEST(RunCoupled, KeepsTheMomentumOfABodyThatNothingTouches) {
  CoupledModel model;
  model.dofs = Rov().dofs;
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

}  // namespace
}  // namespace fathom
