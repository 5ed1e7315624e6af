// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/significance.h"

#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kRate = 0.05;
constexpr int kDraws = 512;  // as many as the search takes

// Suspects with so many independent trials each, every trial a chi squared of so many degrees.
struct Null {
  std::vector<int> num_trials;
  std::vector<int> degrees;
};

// Greatest gain of each suspect where nothing is missing.
Eigen::MatrixXd Maxima(const Null& null, int num_draws, std::uint64_t seed) {
  RandomStream random(seed, "test");
  const int num_suspects = static_cast<int>(null.num_trials.size());
  Eigen::MatrixXd maxima = Eigen::MatrixXd::Zero(num_draws, num_suspects);
  for (int draw = 0; draw < num_draws; ++draw) {
    for (int k = 0; k < num_suspects; ++k) {
      for (int trial = 0; trial < null.num_trials[k]; ++trial) {
        double gain = 0.0;
        for (int i = 0; i < null.degrees[k]; ++i) gain += std::pow(random.Normal(), 2);
        maxima(draw, k) = std::max(maxima(draw, k), gain);
      }
    }
  }
  return maxima;
}

double Tail(int degrees, double x) {
  return degrees == 1 ? std::erfc(std::sqrt(0.5 * x)) : std::exp(-0.5 * x);
}

const Null kIndependent = {{1, 1, 1, 2, 7, 30, 100, 1, 40, 4}, {1, 1, 1, 1, 1, 1, 1, 2, 2, 1}};

const std::vector<double> kNoCaution(10, 1.0);

// The family-wise rate: draws in which any suspect passes its own threshold.
TEST(Significance, LetsNoisePassAsOftenAsItSays) {
  double sum = 0.0;
  const int num_calibrations = 6, num_draws = 2000;
  for (int k = 0; k < num_calibrations; ++k) {
    const Significance significance(
        Maxima(kIndependent, kDraws, 100 + k), kIndependent.degrees, kNoCaution, kRate);
    const Eigen::MatrixXd fresh = Maxima(kIndependent, num_draws, 200 + k);
    int passed = 0;
    for (int draw = 0; draw < num_draws; ++draw) {
      bool any = false;
      for (int s = 0; s < fresh.cols(); ++s) any |= fresh(draw, s) > significance.Threshold(s);
      passed += any;
    }
    sum += static_cast<double>(passed) / num_draws;
  }
  // 12000 draws: a standard deviation of 0.002. The calibration itself: the 0.2 quantile of 512
  // draws is off by 0.018 in probability, a tenth of the number of families and so of the rate,
  // which is 0.005 for one calibration and 0.002 for the mean of six.
  EXPECT_NEAR(sum / num_calibrations, kRate, 4.0 * std::hypot(0.002, 0.002));
}

// n independent trials in each of K independent suspects: 1 - (1 - tail)^n = 1 - 0.95^(1/K).
TEST(Significance, HasTheThresholdsOfIndependentTrials) {
  const Significance significance(
      Maxima(kIndependent, 20000, 1), kIndependent.degrees, kNoCaution, kRate);
  const double each = 1.0 - std::pow(1.0 - kRate, 0.1);
  for (int s = 0; s < 10; ++s) {
    const double tail = 1.0 - std::pow(1.0 - each, 1.0 / kIndependent.num_trials[s]);
    const double threshold = significance.Threshold(s);
    // The number of trials and that of families are known to 2 % each from so many draws, and a
    // threshold falls by 2 for a factor e in the tail (the more for few trials).
    EXPECT_NEAR(std::log(Tail(kIndependent.degrees[s], threshold) / tail), 0.0, 0.15) << s;
    EXPECT_NEAR(significance.FamilyWisePValue(s, threshold), kRate, 1e-9);
  }
}

// Suspects that always gain the same are one, and cost no more than one.
TEST(Significance, CountsCopiesOnce) {
  const Eigen::MatrixXd one = Maxima({{1}, {1}}, 20000, 3);
  Eigen::MatrixXd copies(one.rows(), 5);
  for (auto column : copies.colwise()) column = one.col(0);
  const Significance significance(copies, {1, 1, 1, 1, 1}, std::vector<double>(5, 1.0), kRate);
  // 3.84 is chi squared's 95 % point; it moves by 0.23 if the rate moves by a tenth.
  EXPECT_NEAR(significance.Threshold(4), 3.84, 0.2);
}

// As if there were so many times the tests: the tail at the threshold is divided by that, but for
// terms of its square (5e-5).
TEST(Significance, AsksMoreOfWhatCallsForCaution) {
  const Eigen::MatrixXd maxima = Maxima(kIndependent, kDraws, 5);
  std::vector<double> caution = kNoCaution;
  caution[6] = 2.0;
  caution[5] = 50.0;
  const Significance plain(maxima, kIndependent.degrees, kNoCaution, kRate);
  const Significance asked(maxima, kIndependent.degrees, caution, kRate);
  EXPECT_EQ(asked.Threshold(4), plain.Threshold(4));
  EXPECT_NEAR(Tail(1, asked.Threshold(5)) / Tail(1, plain.Threshold(5)), 0.02, 1e-4);
  EXPECT_NEAR(Tail(1, asked.Threshold(6)) / Tail(1, plain.Threshold(6)), 0.5, 1e-4);
}

TEST(Significance, NeverFindsASuspectThatLeavesNoTrace) {
  Eigen::MatrixXd maxima = Maxima({{1, 1}, {1, 1}}, kDraws, 4);
  maxima.col(1).setZero();
  const Significance significance(maxima, {1, 1}, {1.0, 1.0}, kRate);
  EXPECT_EQ(significance.PValue(1, 90.0), 1.0);
  EXPECT_LT(significance.PValue(0, 90.0), 1e-15);
}

}  // namespace
}  // namespace fathom
