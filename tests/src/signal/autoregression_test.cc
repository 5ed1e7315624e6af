// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/autoregression.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

std::vector<double> SimulateAr2(double phi1, double phi2, double sd, int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, sd);
  std::vector<double> e(n + 500);
  for (int i = 2; i < n + 500; ++i) e[i] = phi1 * e[i - 1] + phi2 * e[i - 2] + normal(generator);
  return {e.begin() + 500, e.end()};
}

TEST(FitAutoregression, RecoversTheRecursionOverSeveralPieces) {
  const std::vector<std::vector<double>> pieces = {SimulateAr2(1.2, -0.5, 0.3, 20000, 1),
                                                   SimulateAr2(1.2, -0.5, 0.3, 7000, 2)};
  const Autoregression noise = FitAutoregression(pieces, 12);
  ASSERT_GE(noise.order(), 2);
  // The sd of an AR(2) coefficient is sqrt((1 - phi2^2) / n) = 0.005.
  EXPECT_NEAR(noise.coefficients[0], 1.2, 0.03);
  EXPECT_NEAR(noise.coefficients[1], -0.5, 0.03);
  EXPECT_NEAR(noise.innovation_variance, 0.09, 4.0 * 0.09 * std::sqrt(2.0 / 27000));
}

TEST(FitAutoregression, FindsAlmostNothingInWhiteNoise) {
  const std::vector<std::vector<double>> pieces = {SimulateAr2(0.0, 0.0, 2.0, 20000, 3)};
  const Autoregression noise = FitAutoregression(pieces, 12);
  double sum = 0.0;
  for (const double phi : noise.coefficients) sum += std::abs(phi);
  EXPECT_LT(sum, 0.1);
  EXPECT_NEAR(noise.innovation_variance, 4.0, 0.2);
}

// Against the covariance matrix of AR(1) noise written out: s^2 phi^|i-j| / (1 - phi^2).
TEST(ColouredGram, MatchesTheDenseCovarianceMatrix) {
  const double phi = 0.8, variance = 0.5;
  const int n = 40;
  Eigen::MatrixXd J(n, 2);
  for (int i = 0; i < n; ++i) J.row(i) << std::sin(0.3 * i) + 0.2, 0.1 * i - 1.0;
  Eigen::MatrixXd Gamma(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      Gamma(i, j) = variance * std::pow(phi, std::abs(i - j)) / (1.0 - phi * phi);
    }
  }
  const Eigen::MatrixXd expected = J.transpose() * Gamma * J;
  const Eigen::MatrixXd gram = ColouredGram({{phi}, variance}, J);
  EXPECT_LT((gram - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
}

TEST(ColouredGram, IsThePlainGramForWhiteNoise) {
  Eigen::MatrixXd J(3, 2);
  J << 1.0, 2.0, -0.5, 0.7, 3.0, -1.1;
  const Eigen::MatrixXd gram = ColouredGram({{}, 2.5}, J);
  EXPECT_LT((gram - 2.5 * J.transpose() * J).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace fathom
