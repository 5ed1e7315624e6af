// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Least squares behind SignalsOf(): what the way from the log's streams to the regression does to
// the parameters.

#include "fathom/least_squares/least_squares.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace fathom {
namespace {

struct Tank {
  UncoupledModel<double> truth;
  std::function<double(double t, double x, double v)> force;
  double velocity_noise = 0.0;  // sd of velocity.csv [m/s]
  double position_noise = 0.0;  // sd of pose.csv [m]
};

// 300 s at 10 Hz. The force is computed at 10 Hz too, but 35 ms after the motion's stamps.
Log LogOf(const Tank& tank, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Log log;
  log.command = Stream{.time = {}, .columns = {"tau_surge"}, .values = {{}}};
  log.velocity = Stream{.time = {}, .columns = {"u"}, .values = {{}}};
  log.pose = Stream{.time = {}, .columns = {"x", "y", "z", "qx", "qy", "qz", "qw"}, .values = {}};
  log.pose->values.resize(7);
  const auto& m = tank.truth;
  const int per_sample = 20;
  const double h = 0.005;
  double x = 0.0, v = 0.0, tau = 0.0;
  for (int i = 0; i <= 60000; ++i) {
    const double t = i * h;
    if (i % per_sample == 0 && i > 0) {
      log.velocity->time.push_back(t);
      log.velocity->values[0].push_back(v + tank.velocity_noise * normal(generator));
      log.pose->time.push_back(t);
      const double row[7] = {x + tank.position_noise * normal(generator), 0, 0, 0, 0, 0, 1};
      for (int k = 0; k < 7; ++k) log.pose->values[k].push_back(row[k]);
    }
    if (i % per_sample == 7) {
      tau = tank.force(t, x, v);
      log.command->time.push_back(t);
      log.command->values[0].push_back(tau);
    }
    // The midpoint rule: its error, (h / time constant)^2, is far below anything here.
    const auto a = [&](double w) {
      return (tau - m.quadratic_damping * w * std::abs(w) - m.linear_damping * w - m.buoyancy) /
             m.inertia;
    };
    const double middle = v + 0.5 * h * a(v);
    x += h * middle;
    v += h * a(middle);
  }
  return log;
}

Tank Steps() {
  return {.truth = {851.05, 120.0, 39.57, -3.0}, .force = [](double t, double, double) {
            const double size = std::fmod(t, 82.0) < 41.0 ? 60.0 : 24.0;
            return std::fmod(t, 26.06) < 13.03 ? size : -size;
          }};
}

// Position control of a sine of 1 m at 0.3 rad/s: the paper's heave.
Tank Heave() {
  return {.truth = {1511.53, 1911.21, 31.4, -12.42}, .force = [](double t, double x, double v) {
            return 1511.53 * (0.64 * (std::sin(0.3 * t) - x) + 1.6 * (0.3 * std::cos(0.3 * t) - v));
          }};
}

TEST(LeastSquaresFromALog, IsUnbiasedUnderStepsOfTheForce) {
  const Tank tank = Steps();
  for (const Source source : {Source::kPoseEstimator, Source::kCamera}) {
    const Signals signals = SignalsOf(LogOf(tank, 1), Dof::kSurge, {.source = source});
    const auto summary = FitLeastSquares(signals.train);
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    // Without noise only v|v| errs, where the velocity's kinks are rounded off over 1 s.
    EXPECT_NEAR(summary.model.inertia, tank.truth.inertia, 0.002 * tank.truth.inertia);
    EXPECT_NEAR(summary.model.quadratic_damping, tank.truth.quadratic_damping, 2.0);
    EXPECT_NEAR(summary.model.linear_damping, tank.truth.linear_damping, 0.5);
    EXPECT_NEAR(summary.model.buoyancy, tank.truth.buoyancy, 0.05);
  }
}

// The inertia is unbiased with noise, too, however wide the chosen window; and the spread over runs
// is what the interval says.
TEST(LeastSquaresFromALog, FindsTheInertiaWithinItsIntervalUnderNoise) {
  struct Case {
    Tank tank;
    Source source;
  };
  std::vector<Case> cases = {{Steps(), Source::kPoseEstimator},
                             {Heave(), Source::kPoseEstimator},
                             {Steps(), Source::kCamera},
                             {Heave(), Source::kCamera}};
  for (Case& test : cases) {
    test.tank.velocity_noise = 0.01;
    test.tank.position_noise = 0.005;
    const int num_runs = 8;
    double sum_of_squared_z = 0.0;
    for (int seed = 0; seed < num_runs; ++seed) {
      const Log log = LogOf(test.tank, seed);
      const auto summary =
          FitLeastSquares(SignalsOf(log, Dof::kSurge, {.source = test.source}).train);
      ASSERT_TRUE(summary.IsUsable()) << summary.message;
      const double truth = test.tank.truth.inertia;
      EXPECT_NEAR(summary.model.inertia, truth, 0.01 * truth);
      EXPECT_GE(summary.model.quadratic_damping, 0.93 * test.tank.truth.quadratic_damping);
      EXPECT_LE(summary.model.quadratic_damping, 1.07 * test.tank.truth.quadratic_damping);
      sum_of_squared_z +=
          std::pow(summary.model.inertia - truth, 2) / summary.covariance(kInertia, kInertia);
    }
    // A mean of 8 chi-square variables: below 1 + 4 sqrt(2 / 8) = 3.
    EXPECT_LT(sum_of_squared_z / num_runs, 3.0);
    EXPECT_GT(sum_of_squared_z / num_runs, 0.05) << "an interval that says nothing";
  }
}

}  // namespace
}  // namespace fathom
