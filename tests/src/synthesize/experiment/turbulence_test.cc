// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/turbulence.h"

#include "fathom/synthesize/synthesize.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Turbulence, HasItsStandardDeviationAndCorrelation) {
  const double sigma = 3.0, T = 2.0;
  const double duration = 40000.0;
  const Turbulence force({.force = sigma, .correlation_time = T}, duration, RandomStream(1, "a"));
  const double step = T / Turbulence::kStepsPerCorrelationTime;
  const int num_points = static_cast<int>(duration / step);
  double sum = 0.0, sum2 = 0.0, product = 0.0;
  int num_products = 0;
  for (int k = 0; k < num_points; ++k) {
    const double now = force.At(k * step) / sigma;
    sum += now;
    sum2 += now * now;
    if (k * step + T >= duration) continue;
    product += now * force.At(k * step + T) / sigma;
    ++num_products;
  }
  // The integral of exp(-2|s|/T) is T, so Bartlett's variance of mean squares is 2 T / duration,
  // and at most that of products; of the mean, 2 T / duration.
  const double five_sigma = 5.0 * std::sqrt(2.0 * T / duration);
  EXPECT_NEAR(sum / num_points, 0.0, five_sigma);
  EXPECT_NEAR(sum2 / num_points, 1.0, five_sigma);
  EXPECT_NEAR(product / num_products, std::exp(-1.0), five_sigma);
}

TEST(Turbulence, IsStraightBetweenItsPointsAndEndsWithTheRun) {
  const Turbulence force({.force = 3.0, .correlation_time = 5.0}, 1.0, RandomStream(1, "a"));
  EXPECT_NEAR(force.At(0.23), 0.7 * force.At(0.2) + 0.3 * force.At(0.3), 1e-12);
  EXPECT_NE(force.At(0.2), force.At(0.3));
  EXPECT_TRUE(std::isfinite(force.At(1.0)));
  EXPECT_TRUE(Turbulence().empty());
  EXPECT_TRUE(
      Turbulence({.force = 0.0, .correlation_time = 5.0}, 1.0, RandomStream(1, "a")).empty());
}

TEST(Turbulence, ShakesALinearVehicleAsMuchAsTheorySays) {
  // m = 1.2, d_L = 3: T = 0.4 s. A force with correlation time 0.2 s makes a speed of variance
  // (sigma / d_L)^2 0.2 / (0.2 + 0.4).
  Vehicle vehicle;
  vehicle.name = "linear";
  vehicle.models[Index(Dof::kSurge)] = {1.2, 0.0, 3.0, 0.0};
  Experiment experiment;
  experiment.name = "rest";
  experiment.duration = 3000.0;
  experiment.command_rate = 1.0;
  experiment.drives = {{.dof = Dof::kSurge,
                        .input = {0.0, StepsInput{.levels = {0.0}, .hold = 1.0}},
                        .pid = {},
                        .turbulence = {.force = 6.0, .correlation_time = 0.2}}};
  experiment.velocity.emplace();
  const Log log = Synthesize(vehicle, experiment, 1);
  double sum2 = 0.0;
  for (const double speed : log.velocity->values[0]) sum2 += speed * speed;
  // The integral of the squared correlation of the speed is 0.733 s: 2.2 % of the variance, five
  // times; 0.7 % for the straight lines.
  EXPECT_NEAR(sum2 / log.velocity->time.size() / (4.0 / 3.0), 1.0, 0.12);
  for (const double force : log.command->values[0]) ASSERT_EQ(force, 0.0);
}

}  // namespace
}  // namespace fathom
