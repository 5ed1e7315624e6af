// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/noise_dynamics.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

NoiseModel Generic() {
  NoiseModel model;
  model.velocity.coloured = {.std = 0.3, .time = 1.7};
  model.displacement.coloured = {.std = 0.05, .time = 0.6};
  model.disturbance = {.std = 0.04, .time = 6.0};
  model.damping_rate = 0.23;
  return model;
}

TEST(NoiseDynamics, TransitionsAreTheClosedForms) {
  const NoiseModel model = Generic();
  const NoiseDynamics dynamics(model);
  const double a = 0.23, b = 1.0 / 6.0;
  for (const double dt : {0.013, 0.2, 1.9, 40.0}) {
    const NoiseTransition t = dynamics.Over(dt);
    const double fast = std::exp(-a * dt), slow = std::exp(-b * dt);
    EXPECT_NEAR(t.w_from_w, slow, 1e-14);
    EXPECT_NEAR(t.v_from_v, fast, 1e-14);
    EXPECT_NEAR(t.v_from_w, (slow - fast) / (a - b), 1e-12);
    EXPECT_NEAR(t.x_from_v, (1.0 - fast) / a, 1e-12);
    EXPECT_NEAR(t.x_from_w, ((1.0 - slow) / b - (1.0 - fast) / a) / (a - b), 1e-10);
    EXPECT_NEAR(t.velocity_c, std::exp(-dt / 1.7), 1e-15);
    EXPECT_NEAR(t.displacement_c, std::exp(-dt / 0.6), 1e-15);
    EXPECT_NEAR(t.q_velocity_c, 0.09 * (1.0 - std::exp(-2.0 * dt / 1.7)), 1e-15);
    EXPECT_NEAR(t.q_displacement_c, 0.0025 * (1.0 - std::exp(-2.0 * dt / 0.6)), 1e-15);
  }
}

// Q is the integral of g(u) g(u)' with g the last interval's response to the white noise that
// drives w, by Simpson's rule. 2000 steps of at most 0.01 time constants: error about 1e-9.
TEST(NoiseDynamics, CovarianceIsTheIntegralOfTheImpulseResponse) {
  const NoiseDynamics dynamics(Generic());
  const double a = 0.23, b = 1.0 / 6.0, density = 2.0 * b * 0.04 * 0.04;
  for (const double dt : {0.013, 0.2, 1.9, 40.0}) {
    double sum[6] = {};
    const int n = 2000;
    for (int i = 0; i <= n; ++i) {
      const double u = dt * i / n;
      const double w = std::exp(-b * u);
      const double v = (std::exp(-b * u) - std::exp(-a * u)) / (a - b);
      const double x = ((1.0 - std::exp(-b * u)) / b - (1.0 - std::exp(-a * u)) / a) / (a - b);
      const double weight = density * dt / n / 3.0 * (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2);
      const double products[6] = {w * w, w * v, v * v, w * x, v * x, x * x};
      for (int j = 0; j < 6; ++j) sum[j] += weight * products[j];
    }
    const NoiseTransition t = dynamics.Over(dt);
    const double q[6] = {t.q_ww, t.q_wv, t.q_vv, t.q_wx, t.q_vx, t.q_xx};
    for (int j = 0; j < 6; ++j) EXPECT_NEAR(q[j], sum[j], 1e-8 * sum[j]) << dt << " " << j;
  }
}

TEST(NoiseDynamics, HasNoTroubleWhereBothRatesAreEqual) {
  NoiseModel equal = Generic(), close = Generic();
  equal.damping_rate = 1.0 / 6.0;
  close.damping_rate = (1.0 + 1e-6) / 6.0;
  const NoiseTransition t = NoiseDynamics(equal).Over(3.0);
  EXPECT_NEAR(t.v_from_w, 3.0 * std::exp(-0.5), 1e-12);  // the limit of the closed form
  EXPECT_NEAR(t.q_vv, NoiseDynamics(close).Over(3.0).q_vv, 1e-5 * t.q_vv);
}

// In a long time v' forgets its start, and its covariance is the stationary one.
TEST(NoiseDynamics, EndsStationary) {
  const NoiseModel model = Generic();
  const NoiseDynamics dynamics(model);
  const NoiseTransition t = dynamics.Over(500.0);
  EXPECT_NEAR(t.q_ww, dynamics.var_w(), 1e-12 * dynamics.var_w());
  EXPECT_NEAR(t.q_wv, dynamics.cov_wv(), 1e-12 * dynamics.cov_wv());
  EXPECT_NEAR(t.q_vv, dynamics.var_v(), 1e-12 * dynamics.var_v());
  EXPECT_NEAR(model.DisturbedVelocityStd(), std::sqrt(dynamics.var_v()), 1e-15);
}

}  // namespace
}  // namespace fathom
