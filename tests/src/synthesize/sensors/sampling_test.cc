// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/sensors/sampling.h"

#include "fathom/synthesize/experiment/correlated_noise.h"

#include <cmath>
#include <cstddef>

#include <gmock/gmock.h>

namespace fathom {
namespace {

TEST(DrawSampleTimes, KeepsAnEvenGridWithoutJitter) {
  const auto samples = DrawSampleTimes({.rate = 4.0, .jitter = 0.0, .drop_outs = {}}, 1.1, 1, "a");
  EXPECT_THAT(samples.time, testing::ElementsAre(0.0, 0.25, 0.5, 0.75, 1.0));
  EXPECT_THAT(samples.has_arrived, testing::Each(true));
  EXPECT_EQ(samples.num_drop_outs, 0);
  EXPECT_EQ(samples.num_lost, 0);
}

TEST(DrawSampleTimes, ScattersTheStampsAboutTheGrid) {
  const int num_samples = 100000;
  const auto samples =
      DrawSampleTimes({.rate = 10.0, .jitter = 0.01, .drop_outs = {}}, 0.1 * num_samples, 1, "a");
  ASSERT_EQ(samples.time.size(), static_cast<std::size_t>(num_samples));
  double sum = 0.0, sum2 = 0.0;
  for (int i = 1; i < num_samples; ++i) {
    const double shift = samples.time[i] - 0.1 * i;
    sum += shift;
    sum2 += shift * shift;
  }
  // Cut off at 4 sigma, which takes 1e-3 of the variance; mean and variance within 5 sigma of
  // theirs.
  EXPECT_NEAR(sum / num_samples, 0.0, 5.0 * 0.01 / std::sqrt(num_samples));
  EXPECT_NEAR(sum2 / num_samples / 1e-4, 1.0, 1e-3 + 5.0 * std::sqrt(2.0 / num_samples));
}

TEST(DrawSampleTimes, KeepsNeighboursApartUnderTheLargestJitter) {
  const auto samples =
      DrawSampleTimes({.rate = 100.0, .jitter = 0.004, .drop_outs = {}}, 300.0, 1, "a");
  for (std::size_t i = 1; i < samples.time.size(); ++i) {
    // A fifth of a period, less the rounding to microseconds.
    ASSERT_GE(samples.time[i] - samples.time[i - 1], 0.002 - 2e-6) << i;
  }
  EXPECT_GE(samples.time.front(), 0.0);
  EXPECT_LT(samples.time.back(), 300.0);
}

TEST(DrawSampleTimes, LosesTheShareThatRenewalTheoryGives) {
  // Bursts of 0.55 s at 10 Hz take 6 samples; between them (1 - p) / p = 49 arrive in the mean.
  const Sampling sampling{.rate = 10.0,
                          .jitter = 0.0,
                          .drop_outs = {.probability = 0.02, .shortest = 0.55, .longest = 0.55}};
  const int num_samples = 200000;
  const auto samples = DrawSampleTimes(sampling, 0.1 * num_samples, 1, "a");
  // The number of renewals has variance N s^2 / m^3, s = sqrt(1 - p) / p = 49.5, m = 55.
  const double sigma = std::sqrt(num_samples) * 49.5 / std::pow(55.0, 1.5);
  EXPECT_NEAR(samples.num_drop_outs, num_samples / 55.0, 5.0 * sigma);
  // The last burst may be cut by the end.
  EXPECT_NEAR(samples.num_lost, 6.0 * samples.num_drop_outs, 6.0);

  int num_lost = 0;
  for (const bool has_arrived : samples.has_arrived) num_lost += has_arrived ? 0 : 1;
  EXPECT_EQ(num_lost, samples.num_lost);
}

TEST(DrawSampleTimes, DrawsTheLengthsOfDropOutsEvenly) {
  const Sampling sampling{.rate = 100.0,
                          .jitter = 0.0,
                          .drop_outs = {.probability = 0.01, .shortest = 0.5, .longest = 1.5}};
  const auto samples = DrawSampleTimes(sampling, 10000.0, 1, "a");
  const int n = samples.num_drop_outs;
  // Cycles of 1 s silence and 0.99 s of speech: some 5000 of them.
  ASSERT_GT(n, 4000);
  // Mean length 1 s, up to a sample more by rounding up (0.005 s in the mean); Var = 1/12.
  EXPECT_NEAR(0.01 * samples.num_lost / n, 1.005, 0.001 + 5.0 * std::sqrt(1.0 / 12.0 / n));
}

TEST(DrawSampleTimes, MovesNoStampWhenDropOutsAreAdded) {
  Sampling sampling{.rate = 10.0, .jitter = 0.01, .drop_outs = {}};
  const auto without = DrawSampleTimes(sampling, 100.0, 1, "a");
  sampling.drop_outs = {.probability = 0.05, .shortest = 1.0, .longest = 2.0};
  const auto with = DrawSampleTimes(sampling, 100.0, 1, "a");
  EXPECT_GT(with.num_lost, 0);
  EXPECT_EQ(with.time, without.time);
}

TEST(CorrelatedNoise, HasItsVarianceAndCorrelationFromTheFirstSample) {
  const double a = 0.8;
  CorrelatedNoise noise(RandomStream(1, "a"), a);
  const int num_samples = 200000;
  double sum2 = 0.0, product1 = 0.0, product3 = 0.0;
  double last[3] = {};
  for (int i = 0; i < num_samples; ++i) {
    const double x = noise.Next();
    sum2 += x * x;
    product1 += x * last[0];
    product3 += x * last[2];
    last[2] = last[1];
    last[1] = last[0];
    last[0] = x;
  }
  // Bartlett: the sums of a process with correlation a^k have at most 2 (1 + a^2) / (1 - a^2) = 9.1
  // times the variance 1/N of white products.
  const double five_sigma = 5.0 * std::sqrt(9.2 / num_samples);
  EXPECT_NEAR(sum2 / num_samples, 1.0, five_sigma);
  EXPECT_NEAR(product1 / num_samples, a, five_sigma);
  EXPECT_NEAR(product3 / num_samples, a * a * a, five_sigma);
}

TEST(CorrelatedNoise, StartsAtItsFullSpread) {
  const int num_runs = 20000;
  double sum2 = 0.0;
  for (int seed = 0; seed < num_runs; ++seed) {
    const double x = CorrelatedNoise(RandomStream(seed, "a"), 0.99).Next();
    sum2 += x * x;
  }
  EXPECT_NEAR(sum2 / num_runs, 1.0, 5.0 * std::sqrt(2.0 / num_runs));
}

}  // namespace
}  // namespace fathom
