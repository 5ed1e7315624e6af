// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/batch_means.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// x_k = a x_(k-1) + e_k: the mean of n scatters by (1 / (1 - a)) / sqrt(n).
TEST(BatchMeans, KnowTheScatterOfTheMeanOfCorrelatedValues) {
  constexpr int kNumRuns = 200, kNumValues = 3200;
  constexpr double kCorrelation = 0.8;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  double sum_of_squares = 0.0;
  for (int run = 0; run < kNumRuns; ++run) {
    Eigen::ArrayXd values(kNumValues);
    double x = 0.0;
    for (double& value : values) value = x = kCorrelation * x + normal(random);
    sum_of_squares += std::pow(ErrorOfMean(values), 2);
  }
  const double variance = 1.0 / std::pow(1.0 - kCorrelation, 2) / kNumValues;
  // The square has 15 degrees of freedom: sqrt(2 / 15 / 200) = 0.026, four times; batches that are
  // 40 correlation times long lose another 2 %.
  EXPECT_NEAR(sum_of_squares / kNumRuns / variance, 1.0, 0.13);
}

TEST(BatchMeans, KnowNothingOfAFewValues) {
  EXPECT_TRUE(std::isinf(ErrorOfMean(Eigen::ArrayXd::Zero(31))));
  EXPECT_EQ(ErrorOfMean(Eigen::ArrayXd::Zero(32)), 0.0);
}

}  // namespace
}  // namespace fathom
