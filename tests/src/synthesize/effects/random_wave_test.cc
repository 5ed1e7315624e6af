// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/random_wave.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(RandomWave, HasItsVarianceAndCorrelationOverRealisations) {
  const int num_runs = 20000;
  double sum = 0.0, sum2 = 0.0, product = 0.0, product2 = 0.0;
  for (int seed = 0; seed < num_runs; ++seed) {
    const double a = RandomWaveAt(seed, 3.0);
    sum += a;
    sum2 += a * a;
    product += a * RandomWaveAt(seed, 3.5);
    product2 += a * RandomWaveAt(seed, 5.0);
  }
  const double five_sigma = 5.0 * std::sqrt(2.0 / num_runs);
  EXPECT_NEAR(sum / num_runs, 0.0, five_sigma);
  EXPECT_NEAR(sum2 / num_runs, 1.0, five_sigma);
  EXPECT_NEAR(product / num_runs, std::exp(-0.5), five_sigma);
  EXPECT_NEAR(product2 / num_runs, std::exp(-2.0), five_sigma);
}

TEST(RandomWave, IsAFunctionOfItsRealisationAndTimeAlone) {
  const double first = RandomWaveAt(7, 1.25);
  const double other = RandomWaveAt(8, 1.25);
  EXPECT_NE(first, other);
  EXPECT_EQ(RandomWaveAt(7, 1.25), first);
  EXPECT_EQ(RandomWaveAt(8, 1.25), other);
}

}  // namespace
}  // namespace fathom
