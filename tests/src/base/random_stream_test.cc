// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/random_stream.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(RandomStream, GivesTheNumbersOfAnIndependentImplementation) {
  // splitmix64, FNV-1a and MT19937-64 written from their papers in Python.
  RandomStream random(7, "velocity.noise.surge");
  EXPECT_EQ(random.Uniform(), 0.4948947516845708);
  EXPECT_EQ(random.Uniform(), 0.33981673971387333);
  EXPECT_EQ(random.Uniform(), 0.1448472815741137);
  RandomStream normal(7, "velocity.noise.surge");
  // Rounding of log, sqrt and cos: a few units in the last place.
  EXPECT_NEAR(normal.Normal(), -0.6343876986054847, 1e-14);
  EXPECT_NEAR(normal.Normal(), 1.0021839010973614, 1e-14);
}

TEST(RandomStream, DiffersBySeedAndByPurpose) {
  const double number = RandomStream(7, "velocity.jitter").Uniform();
  EXPECT_NE(number, RandomStream(8, "velocity.jitter").Uniform());
  EXPECT_NE(number, RandomStream(7, "pose.jitter").Uniform());
  EXPECT_EQ(number, RandomStream(7, "velocity.jitter").Uniform());
}

TEST(RandomStream, DrawsNormalNumbers) {
  RandomStream random(1, "test");
  const int num_draws = 200000;
  double sum = 0.0, sum2 = 0.0, sum4 = 0.0, product = 0.0, last = 0.0;
  int num_beyond = 0;
  for (int i = 0; i < num_draws; ++i) {
    const double x = random.Normal();
    sum += x;
    sum2 += x * x;
    sum4 += x * x * x * x;
    product += x * last;
    last = x;
    if (std::abs(x) > 1.959963985) ++num_beyond;
  }
  // Five standard deviations of each mean: Var x = 1, Var x^2 = 2, Var x^4 = 96, Var(x y) = 1.
  const double five_sigma = 5.0 / std::sqrt(num_draws);
  EXPECT_NEAR(sum / num_draws, 0.0, five_sigma);
  EXPECT_NEAR(sum2 / num_draws, 1.0, five_sigma * std::sqrt(2.0));
  EXPECT_NEAR(sum4 / num_draws, 3.0, five_sigma * std::sqrt(96.0));
  EXPECT_NEAR(product / num_draws, 0.0, five_sigma);
  EXPECT_NEAR(1.0 * num_beyond / num_draws, 0.05, five_sigma * std::sqrt(0.05 * 0.95));
}

}  // namespace
}  // namespace fathom
