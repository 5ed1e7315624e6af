// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/autoregression.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
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

// Of e_i = 1.2 e_{i-1} - 0.5 e_{i-2} + w_i: rho_1 = 1.2 / 1.5, rho_k = 1.2 rho_{k-1} - 0.5
// rho_{k-2}, and the innovation's share of the variance is 1 - 1.2 rho_1 + 0.5 rho_2.
TEST(AutoregressionOf, CovariancesOfARecursionIsThatRecursion) {
  const double first = 1.2 / 1.5, second = 1.2 * first - 0.5, third = 1.2 * second - 0.5 * first;
  const std::vector<double> covariances = {4.0, 4.0 * first, 4.0 * second, 4.0 * third};
  const Autoregression noise = AutoregressionOf(covariances);
  ASSERT_EQ(noise.order(), 3);
  EXPECT_NEAR(noise.coefficients[0], 1.2, 1e-12);
  EXPECT_NEAR(noise.coefficients[1], -0.5, 1e-12);
  EXPECT_NEAR(noise.coefficients[2], 0.0, 1e-12);
  EXPECT_NEAR(noise.innovation_variance, 4.0 * (1.0 - 1.2 * first + 0.5 * second), 1e-12);
}

TEST(FitAutoregression, FindsAlmostNothingInWhiteNoise) {
  const std::vector<std::vector<double>> pieces = {SimulateAr2(0.0, 0.0, 2.0, 20000, 3)};
  const Autoregression noise = FitAutoregression(pieces, 12);
  double sum = 0.0;
  for (const double phi : noise.coefficients) sum += std::abs(phi);
  EXPECT_LT(sum, 0.1);
  EXPECT_NEAR(noise.innovation_variance, 4.0, 0.2);
}

Eigen::MatrixXd TwoColumns(int n) {
  Eigen::MatrixXd J(n, 2);
  for (int i = 0; i < n; ++i) J.row(i) << std::sin(0.3 * i) + 0.2, 0.01 * i - 0.3;
  return J;
}

// J' Gamma J with Gamma written out from the autocovariances of AR(2) noise:
//   g_0 = s^2 (1 - phi_2) / ((1 + phi_2) ((1 - phi_2)^2 - phi_1^2)),   g_1 = phi_1 g_0 / (1 -
//   phi_2), g_k = phi_1 g_{k-1} + phi_2 g_{k-2}
Eigen::MatrixXd DenseGram(double phi1, double phi2, double variance, const Eigen::MatrixXd& J) {
  const Eigen::Index n = J.rows();
  Eigen::VectorXd g(std::max<Eigen::Index>(n, 2));  // of one sample, too, the recursion needs two
  g[0] = variance * (1.0 - phi2) / ((1.0 + phi2) * (1.0 - phi2 - phi1) * (1.0 - phi2 + phi1));
  g[1] = phi1 * g[0] / (1.0 - phi2);
  for (Eigen::Index k = 2; k < n; ++k) g[k] = phi1 * g[k - 1] + phi2 * g[k - 2];
  Eigen::MatrixXd Gamma(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) Gamma(i, j) = g[std::abs(i - j)];
  }
  return J.transpose() * Gamma * J;
}

void ExpectClose(const Eigen::MatrixXd& gram, const Eigen::MatrixXd& expected) {
  EXPECT_LT((gram - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
}

TEST(ColouredGram, MatchesTheDenseCovarianceMatrix) {
  const Eigen::MatrixXd J = TwoColumns(700);
  ColouredGram coloured({{1.2, -0.5}, 0.3}, 2);
  coloured.Add(J);
  ExpectClose(coloured.EndPiece(), DenseGram(1.2, -0.5, 0.3, J));
}

// Noise that remembers a thousand samples, in a piece of forty.
TEST(ColouredGram, HoldsForAPieceShorterThanTheMemoryOfTheNoise) {
  const Eigen::MatrixXd J = TwoColumns(40);
  ColouredGram coloured({{0.999}, 0.5}, 2);
  coloured.Add(J);
  ExpectClose(coloured.EndPiece(), DenseGram(0.999, 0.0, 0.5, J));
}

// Noise that rings for a hundred thousand samples: its echo is not followed to its end.
TEST(ColouredGram, HoldsForNoiseThatRingsOnFarBeyondThePiece) {
  const Eigen::MatrixXd J = TwoColumns(40);
  const double radius = 1.0 - 1e-5;
  const double phi1 = 2.0 * radius * std::cos(0.3), phi2 = -radius * radius;
  ColouredGram coloured({{phi1, phi2}, 0.5}, 2);
  coloured.Add(J);
  ExpectClose(coloured.EndPiece(), DenseGram(phi1, phi2, 0.5, J));
  coloured.Add(J.topRows(1));
  ExpectClose(coloured.EndPiece(), DenseGram(phi1, phi2, 0.5, J.topRows(1)));
}

TEST(ColouredGram, TakesRowsInAnyPortionsAndOnePieceAfterTheOther) {
  const Eigen::MatrixXd J = TwoColumns(1300);
  ColouredGram coloured({{1.2, -0.5}, 0.3}, 2);
  coloured.Add(J.topRows(300));
  coloured.EndPiece();
  coloured.Add(J.topRows(1));
  coloured.Add(J.middleRows(1, 1100));
  coloured.Add(J.bottomRows(199));
  ExpectClose(coloured.EndPiece(), DenseGram(1.2, -0.5, 0.3, J));
}

// Three moving averages over 31 samples in a row: what a derivative by a window of a second leaves
// of noise at 100 Hz.
std::vector<double> Smoothed(std::vector<double> values) {
  for (int pass = 0; pass < 6; ++pass) {
    std::vector<double> averages(values.size() - 30);
    for (size_t i = 0; i < averages.size(); ++i) {
      for (size_t k = 0; k < 31; ++k) averages[i] += values[i + k] / 31.0;
    }
    values = std::move(averages);
  }
  return values;
}

TEST(ColouredGram, HoldsForNoiseOfWhichAlmostNothingIsNew) {
  std::vector<double> white = SimulateAr2(0.0, 0.0, 1.0, 40000, 5);
  const Autoregression noise = FitAutoregression({Smoothed(white)}, 60);
  ASSERT_GT(noise.order(), 15);
  const int n = 1500;
  Eigen::MatrixXd J(n, 1);
  for (int i = 0; i < n; ++i) J(i, 0) = std::sin(0.01 * i);
  ColouredGram coloured(noise, 1);
  coloured.Add(J);
  // Written out: sum_i J_i e_i is a sum over the white samples, each with the average of J about
  // it.
  std::vector<double> padded(n + 360, 0.0);
  for (int i = 0; i < n; ++i) padded[180 + i] = J(i, 0);
  double variance = 0.0;
  for (const double a : Smoothed(padded)) variance += a * a;
  // A spectral density by an order of p from n samples: sqrt(2 p / n) is 5.5 %.
  EXPECT_NEAR(coloured.EndPiece()(0, 0) / variance, 1.0, 0.2);
}

TEST(ColouredGram, IsThePlainGramForWhiteNoise) {
  Eigen::MatrixXd J(3, 2);
  J << 1.0, 2.0, -0.5, 0.7, 3.0, -1.1;
  ColouredGram coloured({{}, 2.5}, 2);
  coloured.Add(J);
  EXPECT_LT((coloured.EndPiece() - 2.5 * J.transpose() * J).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace fathom
