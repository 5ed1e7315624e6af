// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/noise_floor.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// A speed with noise, and a prediction that misses it slowly by `slow`. `true_nmae`: of the truth.
struct NoisyRun {
  FreeRun run;
  double true_nmae = 0.0;
};

NoisyRun RunWith(double std, double slow) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, std);
  NoisyRun noisy;
  double misses = 0.0, measured = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double t = 0.1 * i, truth = 0.4 * std::sin(0.3 * t), noise = normal(generator);
    noisy.run.time.push_back(t);
    noisy.run.measured.push_back(truth + noise);
    noisy.run.predicted.push_back(truth + slow * std::sin(0.2 * t));
    misses += std::abs(noise);
    measured += std::abs(truth + noise);
  }
  noisy.true_nmae = misses / measured;
  return noisy;
}

// Median and mean of 20000 sizes that overlap are known to about 1 %.
TEST(NoiseFloor, IsTheNmaeOfTheTruth) {
  const NoisyRun noisy = RunWith(0.07, 0.0);
  EXPECT_NEAR(ScatterVariance({&noisy.run, 1}), 0.07 * 0.07, 0.06 * 0.07 * 0.07);
  EXPECT_NEAR(NmaeOfScatter({&noisy.run, 1}), noisy.true_nmae, 0.03 * noisy.true_nmae);
}

TEST(NoiseFloor, KnowsNothingOfASlowError) {
  const NoisyRun noisy = RunWith(0.07, 0.2);
  EXPECT_NEAR(NmaeOfScatter({&noisy.run, 1}), noisy.true_nmae, 0.03 * noisy.true_nmae);
}

// docs/diagnosis.md says: to about 3 % from a minute at 10 Hz.
TEST(NoiseFloor, IsKnownAsWellAsTheManualSays) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  constexpr int kNumTrials = 1000;
  double squares = 0.0;
  for (int trial = 0; trial < kNumTrials; ++trial) {
    FreeRun run;
    double misses = 0.0, measured = 0.0;
    for (int i = 0; i < 600; ++i) {
      const double noise = 0.02 * normal(generator), truth = 0.4 * std::sin(0.05 * i);
      run.time.push_back(0.1 * i);
      run.predicted.push_back(truth);
      run.measured.push_back(truth + noise);
      misses += std::abs(noise);
      measured += std::abs(truth + noise);
    }
    const double off = NmaeOfScatter({&run, 1}) / (misses / measured) - 1.0;
    squares += off * off;
  }
  EXPECT_NEAR(std::sqrt(squares / kNumTrials), 0.0306, 0.003);
}

TEST(NoiseFloor, IsNotKnownWithoutData) {
  EXPECT_TRUE(std::isnan(NmaeOfScatter({})));
  const FreeRun two = {{0.0, 0.1}, {0.2, 0.3}, {0.2, 0.2}};
  EXPECT_TRUE(std::isnan(NmaeOfScatter({&two, 1})));
}

}  // namespace
}  // namespace fathom
