// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_motion.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

std::vector<double> Stamps(double step, int count) {
  std::vector<double> time;
  for (int i = 0; i < count; ++i) time.push_back(step * i);
  return time;
}

// dv/dt = -a v - b v^2 has v = a v0 e / (a + b v0 (1 - e)), e = exp(-a t).
TEST(SimulateDecay, FollowsTheClosedFormOfACoastDown) {
  const double a = 0.2, b = 0.48, v0 = 0.73;
  const auto time = Stamps(0.5, 40);
  const auto samples = SimulateDecay({a, b, 0.0, 0.0}, v0, 0.0, time);
  ASSERT_EQ(samples.size(), time.size());
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double e = std::exp(-a * time[i]);
    // Runge and Kutta's error with steps of a tenth of a time constant: 1e-7.
    EXPECT_NEAR(samples[i].velocity, a * v0 * e / (a + b * v0 * (1.0 - e)), 1e-7);
  }
}

// x = x0 exp(-a t / 2) (cos w t + a / (2 w) sin w t), w^2 = c - a^2 / 4.
TEST(SimulateDecay, FollowsTheClosedFormOfARoll) {
  const double a = 0.3, c = 4.0, x0 = 0.35;
  const double w = std::sqrt(c - a * a / 4.0);
  const auto time = Stamps(0.1, 100);
  const auto samples = SimulateDecay({a, 0.0, c, 0.0}, 0.0, x0, time);
  ASSERT_EQ(samples.size(), time.size());
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double t = time[i];
    const double x =
        x0 * std::exp(-a * t / 2.0) * (std::cos(w * t) + a / 2.0 / w * std::sin(w * t));
    EXPECT_NEAR(samples[i].displacement, x, 1e-6);
  }
}

TEST(SimulateDecay, HasTheDerivativesOfFiniteDifferences) {
  const auto time = Stamps(0.2, 30);
  const double at[] = {0.2, 0.5, 1.5, 0.03, 0.6, 0.2};
  const auto run = [&](int column, double by) {
    double p[6];
    for (int k = 0; k < 6; ++k) p[k] = at[k] + (k == column ? by : 0.0);
    return SimulateDecay({p[0], p[1], p[2], p[3]}, p[4], p[5], time);
  };
  const auto samples = run(-1, 0.0);
  for (int column = 0; column < kNumDecaySensitivities; ++column) {
    const double h = 1e-4;
    const auto above = run(column, h), below = run(column, -h);
    for (std::size_t i = 0; i < time.size(); ++i) {
      // Central differences are off by h^2, where the speed passes 0 by h.
      EXPECT_NEAR(samples[i].velocity_gradient[column],
                  (above[i].velocity - below[i].velocity) / (2.0 * h),
                  2e-5);
      EXPECT_NEAR(samples[i].displacement_gradient[column],
                  (above[i].displacement - below[i].displacement) / (2.0 * h),
                  2e-5);
    }
  }
}

}  // namespace
}  // namespace fathom
