// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Fins and shafts, against a second simulator and closed forms.

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "plain_simulator.h"
#include "test_rov.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

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

// The velocity after each of `num_steps` steps of 2 s, within `tolerance`; `advance` takes the
// second simulator, which knows neither fins nor shafts, over a step.
void ExpectASecondSimulatorComesTo(
    const CoupledModel& model,
    const CoupledInputs& inputs,
    int num_steps,
    double tolerance,
    const std::function<void(std::size_t step, PlainSimulator* plain)>& advance) {
  CoupledStamps stamps;
  for (int k = 0; k < num_steps; ++k) stamps.velocity.push_back(2.0 * k + 2.0);
  CoupledOutputs outputs;
  ASSERT_TRUE(RunCoupled(model, inputs, Moving(), stamps, &outputs));
  PlainSimulator plain(Rov());
  plain.nu = Moving().nu;
  plain.world_from_body = Eigen::Quaterniond(Moving().attitude).toRotationMatrix();
  for (std::size_t k = 0; k < stamps.velocity.size(); ++k) {
    advance(k, &plain);
    EXPECT_LT((outputs.velocity[k] - plain.nu).norm(), tolerance) << k;
  }
}

TEST(RunCoupled, GoesWithFinsAsASecondSimulatorDoes) {
  const CoupledModel model = FinnedRov();
  const CoupledInputs inputs = FinnedSteps(15);
  ExpectASecondSimulatorComesTo(model, inputs, 15, 5e-5, [&](std::size_t k, PlainSimulator* plain) {
    plain->more = [&](const Vector6& nu) { return PlainFins(inputs, k, nu); };
    plain->Advance(ForceOf(model, inputs, k), 2.0, 2e-4);
  });
}

// The angle that a fin comes to within a time, by a rate.
double Turned(double from, double towards, double most) {
  return from + std::clamp(towards - from, -most, most);
}

TEST(RunCoupled, GoesWithFinsOfALimitedRateAsASecondSimulatorDoes) {
  CoupledModel model = FinnedRov();
  model.fin_rate_limit = {{"rudder", 0.23}, {"plane", 0.4}};
  const CoupledInputs inputs = FinnedSteps(8);
  constexpr double kStep = 5e-4;
  CoupledInputs turned = inputs;
  double rudder = 0.0, plane = 0.0;
  ExpectASecondSimulatorComesTo(model, inputs, 8, 5e-5, [&](std::size_t k, PlainSimulator* plain) {
    plain->more = [&](const Vector6& nu) { return PlainFins(turned, k, nu); };
    for (int i = 0; i < 4000; ++i) {
      const double to_rudder = inputs.command.fins[0].angle[k];
      const double to_plane = inputs.command.fins[1].angle[k];
      turned.command.fins[0].angle[k] = Turned(rudder, to_rudder, 0.5 * kStep * 0.23);
      turned.command.fins[1].angle[k] = Turned(plane, to_plane, 0.5 * kStep * 0.4);
      rudder = Turned(rudder, to_rudder, kStep * 0.23);
      plane = Turned(plane, to_plane, kStep * 0.4);
      plain->Advance(ForceOf(model, inputs, k), kStep, kStep);
    }
  });
}

TEST(RunCoupled, GoesWithFinsThatStallAsASecondSimulatorDoes) {
  CoupledModel model = FinnedRov();
  model.fin_stall = {{"rudder", 0.2}, {"plane", 0.2}, {"stuck", 0.2}};
  const CoupledInputs inputs = FinnedSteps(8);
  ExpectASecondSimulatorComesTo(model, inputs, 8, 1e-4, [&](std::size_t k, PlainSimulator* plain) {
    plain->more = [&](const Vector6& nu) { return PlainFins(inputs, k, nu, 0.2); };
    plain->Advance(ForceOf(model, inputs, k), 2.0, 2e-4);
  });
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
  ExpectASecondSimulatorComesTo(model, inputs, 12, 1e-4, [&](std::size_t k, PlainSimulator* plain) {
    const double turns = inputs.command.shafts[0].turns[k];
    plain->more = [&inputs, k, turns](const Vector6& nu) -> Vector6 {
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
    plain->Advance(ForceOf(model, inputs, k), 2.0, 5e-4);
  });
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

}  // namespace
}  // namespace fathom
