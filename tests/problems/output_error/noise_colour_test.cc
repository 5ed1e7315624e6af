// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/noise_colour.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kSlow = 0.97;     // correlation of the slow part from sample to sample
constexpr double kSlowStd = 0.25;  // beside white noise of 1

std::vector<double> SlowAmongWhite(std::size_t num, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  double slow = kSlowStd * normal(random);
  std::vector<double> noise;
  for (std::size_t i = 0; i < num; ++i) {
    noise.push_back(normal(random) + slow);
    slow = kSlow * slow + kSlowStd * std::sqrt(1.0 - kSlow * kSlow) * normal(random);
  }
  return noise;
}

// Mean over 40 residuals of 3000 samples, over the truth: 1 + s^2 (1 + c) / (1 - c).
double LongRunVarianceOverTruth(std::size_t bin_size) {
  constexpr int kNum = 40;
  double sum = 0.0;
  for (unsigned seed = 1; seed <= kNum; ++seed) {
    const std::vector<std::vector<double>> pieces = {SlowAmongWhite(3000, seed)};
    sum += SlowerColour(ColourOfSamples(pieces), pieces, bin_size).LongRunVariance();
  }
  return sum / kNum / (1.0 + kSlowStd * kSlowStd * (1.0 + kSlow) / (1.0 - kSlow));
}

TEST(SlowerColour, KnowsWhatAicTakesForWhite) {
  EXPECT_LT(LongRunVarianceOverTruth(1), 0.75);
  EXPECT_NEAR(LongRunVarianceOverTruth(8), 1.0, 0.2);
}

TEST(BinLosses, AreThoseOfASine) {
  // Means over m samples of a sine of w per sample leave (sin(m w / 2) / (m sin(w / 2)))^2 of its
  // power: with 0.02 a sample 0.48 % is lost to twelve samples, 0.85 % would be to sixteen.
  Eigen::VectorXd sine(31416);
  for (Eigen::Index i = 0; i < sine.size(); ++i) sine[i] = std::sin(0.02 * static_cast<double>(i));
  BinLosses losses;
  EXPECT_EQ(losses.LargestSize(), 1U) << "nothing was simulated";
  losses.Add(sine);
  EXPECT_EQ(losses.LargestSize(), 12U);
  BinLosses of_few;
  of_few.Add(sine.head(1000));
  EXPECT_EQ(of_few.LargestSize(), 3U) << "fewer than 300 bins";
}

TEST(BinnedRows, AreSumsHoweverTheyArrive) {
  const Eigen::MatrixXd rows = Eigen::MatrixXd::Random(17, 3);
  BinnedRows at_once(5, 3), one_by_one(5, 3);
  at_once.Add(rows, true);
  Eigen::MatrixXd expected(4, 3);
  for (Eigen::Index k = 0; k < 4; ++k) {
    expected.row(k) = rows.middleRows(5 * k, k < 3 ? 5 : 2).colwise().sum();
  }
  EXPECT_TRUE(at_once.full().isApprox(expected, 1e-12));
  Eigen::Index num = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    one_by_one.Add(rows.row(i), i + 1 == rows.rows());
    for (Eigen::Index k = 0; k < one_by_one.full().rows(); ++k, ++num) {
      EXPECT_TRUE(one_by_one.full().row(k).isApprox(expected.row(num), 1e-12)) << num;
    }
  }
  EXPECT_EQ(num, 4);
}

}  // namespace
}  // namespace fathom
