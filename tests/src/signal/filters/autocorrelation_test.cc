// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/autocorrelation.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "stationary_noise.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// 200 runs of 40 lags: the rate has a standard error of 0.0024 if all were independent.
TEST(Autocorrelation, OfWhiteNoiseStaysWithinItsBounds95PerCentOfTheTime) {
  int inside = 0, count = 0;
  std::mt19937 generator(1);
  for (int run = 0; run < 200; ++run) {
    const std::vector<std::vector<double>> noise = {WhiteNoise(400, 0.3, &generator),
                                                    WhiteNoise(250, 0.3, &generator)};
    const Autocorrelation result = AutocorrelationOf(noise, 0.1, 40);
    for (std::size_t k = 0; k < result.lag.size(); ++k) {
      inside += std::abs(result.value[k]) <= result.bound[k] ? 1 : 0;
      ++count;
    }
  }
  EXPECT_EQ(count, 8000);
  EXPECT_NEAR(inside / 8000.0, 0.95, 0.01);
}

// r_k = a^k. The standard error at a = 0.8 is sqrt((1 + a^2) / (1 - a^2) / n) = 0.0068 at most.
TEST(Autocorrelation, OfAnAutoregressionIsItsClosedForm) {
  std::mt19937 generator(2);
  const std::vector<std::vector<double>> noise = {FirstOrderNoise(60000, 0.8, 2.0, &generator),
                                                  FirstOrderNoise(40000, 0.8, 2.0, &generator)};
  const Autocorrelation result = AutocorrelationOf(noise, 0.25, 12);
  ASSERT_EQ(result.lag.size(), 12u);
  for (int k = 1; k <= 12; ++k) {
    EXPECT_NEAR(result.lag[k - 1], 0.25 * k, 1e-12);
    EXPECT_NEAR(result.value[k - 1], std::pow(0.8, k), 4.0 * 0.0068);
  }
}

// By hand: 1*2 + 2*4 + 4*(-1) + (-1)*3 = 3 and, in the second segment, 3*1 + 1*5 + 5*0 = 8, of the
// squares 1 + 4 + 16 + 1 + 9 and 9 + 1 + 25 + 0.
TEST(Autocorrelation, TakesNoProductAcrossTheEndsOfSegments) {
  const std::vector<std::vector<double>> segments = {{1, 2, 4, -1, 3}, {3, 1, 5, 0}};
  const Autocorrelation result = AutocorrelationOf(segments, 1.0, 9);
  ASSERT_EQ(result.value.size(), 1u);
  EXPECT_NEAR(result.value[0], 11.0 / 66.0, 1e-15);
  EXPECT_NEAR(result.bound[0], 1.96 * std::sqrt(7.0) / 9.0, 1e-15);
}

TEST(Autocorrelation, KeepsAMean) {
  const std::vector<std::vector<double>> constant = {std::vector<double>(1000, -0.2)};
  EXPECT_NEAR(AutocorrelationOf(constant, 0.1, 1).value.at(0), 0.999, 1e-12);
}

TEST(Autocorrelation, IsEmptyWhereNothingIsLeft) {
  const std::vector<std::vector<double>> zero = {std::vector<double>(100, 0.0)};
  EXPECT_TRUE(AutocorrelationOf(zero, 0.1, 10).lag.empty());
  EXPECT_TRUE(AutocorrelationOf({}, 0.1, 10).lag.empty());
}

}  // namespace
}  // namespace fathom
