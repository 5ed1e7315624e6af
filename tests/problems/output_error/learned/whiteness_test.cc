// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/whiteness.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// `num_samples` in two segments: x_i = a x_(i-1) + w_i with variance share^2, and white noise of
// variance 1.
std::vector<std::vector<double>> Noise(unsigned seed, int num_samples, double a, double share) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> segments(2);
  double x = 0.0;
  for (int i = 0; i < num_samples; ++i) {
    x = a * x + std::sqrt(1.0 - a * a) * normal(generator);
    segments[i < num_samples / 3 ? 0 : 1].push_back(share * x + normal(generator));
  }
  return segments;
}

double RateOfWhite(int num_samples, double a, double share) {
  constexpr int kNumTrials = 1000;
  int num_white = 0;
  for (unsigned seed = 0; seed < kNumTrials; ++seed) {
    num_white += IsWhite(Noise(seed, num_samples, a, share)) ? 1 : 0;
  }
  return num_white / static_cast<double>(kNumTrials);
}

// Of 3000 samples there are six lengths of means, of 500 three. Each is above two standard
// deviations with a chance of 2.3 to 3 % (of a sum of squares), nearly independent of the others.
TEST(IsWhite, CallsMostWhiteSeriesWhite) {
  EXPECT_NEAR(RateOfWhite(3000, 0.0, 0.0), 0.85, 0.04);
  EXPECT_NEAR(RateOfWhite(500, 0.0, 0.0), 0.92, 0.04);
}

// Means of K = 1/(1-a) samples have about 0.6 K share^2 times the white variance more; with 3000/K
// of them the spread is sqrt(2 K / 3000).
TEST(IsWhite, SeesColourThatMattersToAFit) {
  EXPECT_LT(RateOfWhite(3000, 0.9, 0.33), 0.01);   // 0.65 with a spread of 0.08
  EXPECT_LT(RateOfWhite(3000, 0.98, 0.2), 0.01);   // 1.2 with a spread of 0.18
  EXPECT_LT(RateOfWhite(3000, 0.995, 0.2), 0.05);  // 4.8 with a spread of 0.37
}

TEST(IsWhite, LeavesWildSamplesOut) {
  const auto clean = Noise(1, 3000, 0.0, 0.0);
  ASSERT_TRUE(IsWhite(clean));
  for (const auto& [size, is_white] : {std::pair(30.0, true), std::pair(4.0, false)}) {
    auto residuals = clean;
    for (std::size_t i = 400; i < 420; ++i) residuals[1][i] = size;
    EXPECT_EQ(IsWhite(residuals), is_white) << size;
  }
}

// Too few for 32 pairs: nothing is claimed against them.
TEST(IsWhite, CallsAFewSamplesWhite) {
  const std::vector<std::vector<double>> residuals = {std::vector<double>(40, 1.0)};
  EXPECT_TRUE(IsWhite(residuals));
}

}  // namespace
}  // namespace fathom
