// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/simulate.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr UncoupledModel<double> kSimulatedModel = {12.0, 7.0, 3.0, -1.5};

struct Result {
  std::vector<double> velocity;
  std::vector<double> position;
};

Result Simulate(const UncoupledModel<double>& model,
                const HeldCommand& command,
                const InitialState& initial,
                const std::vector<double>& time) {
  const Simulation simulation(command, time);
  Result result{std::vector<double>(time.size()), std::vector<double>(time.size())};
  EXPECT_TRUE(simulation.Run(model, initial, result.velocity, result.position));
  return result;
}

TEST(Simulation, MatchesTheClosedFormUnderLinearDamping) {
  // v = v_inf + (v0 - v_inf) exp(-t / T), T = m / d_L, v_inf = (tau - b) / d_L.
  const UncoupledModel<double> model = {12.0, 0.0, 3.0, -1.5};
  const std::vector<double> time = {2.0, 2.3, 4.7, 11.0};
  const auto result = Simulate(model, {{0.0}, {4.0}}, {0.4, 0.7}, time);
  const double v_end = (4.0 + 1.5) / 3.0, time_constant = 4.0;
  for (size_t i = 0; i < time.size(); ++i) {
    const double t = time[i] - time[0];
    const double decay = std::exp(-t / time_constant);
    // Steps of at most 0.1 T: local error (0.1)^5 / 120 = 8e-8 a step, some 30 steps.
    EXPECT_NEAR(result.velocity[i], v_end + (0.4 - v_end) * decay, 1e-6);
    EXPECT_NEAR(
        result.position[i], 0.7 + v_end * t + (0.4 - v_end) * time_constant * (1.0 - decay), 1e-5);
  }
}

TEST(Simulation, MatchesTheClosedFormCoastDownInBothDirections) {
  // With quadratic damping alone, v = v0 / (1 + d_Q |v0| t / m).
  const UncoupledModel<double> model = {10.0, 3.0, 0.0, 0.0};
  for (const double v0 : {1.5, -1.5}) {
    const auto result = Simulate(model, {{0.0}, {0.0}}, {v0, 0.0}, {0.0, 1.0, 4.0});
    EXPECT_NEAR(result.velocity[1], v0 / (1.0 + 3.0 * 1.5 * 1.0 / 10.0), 1e-7);
    EXPECT_NEAR(result.velocity[2], v0 / (1.0 + 3.0 * 1.5 * 4.0 / 10.0), 1e-7);
  }
}

TEST(Simulation, ChangesTheCommandAtItsOwnStampsNotAtTheOutputs) {
  // Without damping, m dv = tau dt: the impulse of the held command alone counts.
  const UncoupledModel<double> model = {2.0, 0.0, 0.0, 0.0};
  const HeldCommand command = {{1.0, 1.25, 1.7}, {8.0, -4.0, 0.0}};
  const auto result = Simulate(model, command, {0.0, 0.0}, {0.0, 1.1, 1.6, 3.0});
  EXPECT_NEAR(result.velocity[1], 8.0 * 0.1 / 2.0, 1e-14);
  EXPECT_NEAR(result.velocity[2], (8.0 * 0.25 - 4.0 * 0.35) / 2.0, 1e-14);
  EXPECT_NEAR(result.velocity[3], (8.0 * 0.25 - 4.0 * 0.45) / 2.0, 1e-14);
}

TEST(Simulation, TakesACommandStampThatCoincidesWithAnOutput) {
  const UncoupledModel<double> model = {2.0, 0.0, 0.0, 0.0};
  const HeldCommand command = {{0.0, 1.0, 2.0}, {2.0, 6.0, -2.0}};
  const auto result = Simulate(model, command, {0.0, 0.0}, {0.0, 1.0, 2.0, 3.0});
  EXPECT_NEAR(result.velocity[1], 1.0, 1e-14);
  EXPECT_NEAR(result.velocity[2], 4.0, 1e-14);
  EXPECT_NEAR(result.velocity[3], 3.0, 1e-14);
}

TEST(Simulation, CommandsNothingBeforeTheFirstStamp) {
  const auto result = Simulate({2.0, 0.0, 0.0, 0.0}, {{5.0}, {2.0}}, {0.3, 0.0}, {0.0, 5.0, 6.0});
  EXPECT_NEAR(result.velocity[1], 0.3, 1e-15);
  EXPECT_NEAR(result.velocity[2], 1.3, 1e-14);
}

// The convergence order, seen through command stamps that force ever shorter steps.
TEST(Simulation, HalvingTheStepDividesTheErrorBySixteen) {
  const UncoupledModel<double> model = {10.0, 30.0, 0.0, 0.0};
  const auto error_with = [&](int num_steps) {
    HeldCommand command;
    for (int i = 0; i <= num_steps; ++i) {
      command.time.push_back(0.2 * i / num_steps);
      command.value.push_back(0.0);
    }
    // The damping's time constant is 10 / (2 30 0.25) = 0.67 s: steps below 0.067 s stay whole.
    const auto result = Simulate(model, command, {0.25, 0.0}, {0.0, 0.2});
    return std::abs(result.velocity[1] - 0.25 / (1.0 + 30.0 * 0.25 * 0.2 / 10.0));
  };
  EXPECT_NEAR(error_with(4) / error_with(8), 16.0, 1.0);
}

TEST(Simulation, SensitivitiesMatchFiniteDifferences) {
  HeldCommand command;
  std::vector<double> time;
  for (int i = 0; i < 60; ++i) {
    command.time.push_back(0.37 * i);
    command.value.push_back(9.0 * std::sin(0.4 * i) + 3.0);
    time.push_back(0.31 * i);
  }
  const Simulation simulation(command, time);
  const int n = simulation.num_outputs(), columns = Simulation::kNumSensitivities;
  std::vector<double> velocity(n), position(n), dv(n * columns), dx(n * columns);
  ASSERT_TRUE(
      simulation.RunWithSensitivities(kSimulatedModel, {0.2, 1.0}, velocity, position, dv, dx));

  const Result plain = Simulate(kSimulatedModel, command, {0.2, 1.0}, time);
  for (int column = 0; column < columns; ++column) {
    const double h = 1e-5;
    const auto shifted = [&](double sign) {
      double p[] = {12.0, 7.0, 3.0, -1.5, 0.2};
      p[column] += sign * h;
      return Simulate({p[0], p[1], p[2], p[3]}, command, {p[4], 1.0}, time);
    };
    const Result up = shifted(+1.0), down = shifted(-1.0);
    for (int i = 0; i < n; ++i) {
      // Central differences: truncation about h^2, rounding about 1e-16 / h.
      EXPECT_NEAR(dv[i * columns + column], (up.velocity[i] - down.velocity[i]) / (2.0 * h), 1e-8);
      EXPECT_NEAR(dx[i * columns + column], (up.position[i] - down.position[i]) / (2.0 * h), 1e-7);
      EXPECT_NEAR(velocity[i], plain.velocity[i], 1e-13);  // rounding alone
      EXPECT_NEAR(position[i], plain.position[i], 1e-12);
    }
  }
}

TEST(Simulation, DividesStepsLongAgainstTheDamping) {
  // Time constant 0.02 s, outputs 1 s apart: an undivided step would blow up.
  const UncoupledModel<double> model = {1.0, 0.0, 50.0, 0.0};
  const auto result = Simulate(model, {{0.0}, {100.0}}, {0.0, 0.0}, {0.0, 1.0, 2.0});
  EXPECT_NEAR(result.velocity[2], 2.0, 1e-9);
}

// From rest under a strong force the damping's rate grows as the vehicle does: the speed at the
// step's start says nothing about it. With quadratic damping alone, v = v_inf tanh(tau t / m
// v_inf).
TEST(Simulation, DividesALongStepThatStartsFromRest) {
  const UncoupledModel<double> model = {1511.53, 1911.21, 0.0, 0.0};
  const auto result = Simulate(model, {{0.0}, {200.0}}, {0.0, 0.0}, {0.0, 8.0, 30.0});
  const double v_end = std::sqrt(200.0 / 1911.21);
  EXPECT_NEAR(result.velocity[1], v_end * std::tanh(200.0 * 8.0 / (1511.53 * v_end)), 1e-6);
  EXPECT_NEAR(result.velocity[2], v_end * std::tanh(200.0 * 30.0 / (1511.53 * v_end)), 1e-6);
}

TEST(Simulation, SaysSoWhenTheModelDiverges) {
  std::vector<double> velocity(2);
  const std::vector<double> time = {0.0, 100.0};
  const Simulation simulation({{0.0}, {1.0}}, time);
  EXPECT_FALSE(simulation.Run({1.0, 0.0, -5.0, 0.0}, {}, velocity, {}));   // grows without bound
  EXPECT_FALSE(simulation.Run({1e-6, 0.0, 50.0, 0.0}, {}, velocity, {}));  // far too stiff
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(simulation.Run({nan, 0.0, 1.0, 0.0}, {}, velocity, {}));
}

}  // namespace
}  // namespace fathom
