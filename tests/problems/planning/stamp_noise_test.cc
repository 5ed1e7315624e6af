// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/stamp_noise.h"

#include "fathom/base/input_error.h"
#include "fathom/base/random_stream.h"
#include "fathom/planning/information.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// phi_1 = 1.1, phi_2 = -0.3: Yule-Walker gives rho_1 = phi_1 / (1 - phi_2), then the recursion.
TEST(StampNoise, HasTheCorrelationsOfYuleAndWalker) {
  const std::vector<double> found = CorrelationsOf(std::vector<double>{1.1, -0.3}, 4);
  const double one = 1.1 / 1.3, two = 1.1 * one - 0.3, three = 1.1 * two - 0.3 * one;
  EXPECT_NEAR(found[0], 1.0, 1e-12);
  EXPECT_NEAR(found[1], one, 1e-8);
  EXPECT_NEAR(found[2], two, 1e-8);
  EXPECT_NEAR(found[3], three, 1e-8);
}

TEST(StampNoise, RefusesNoiseThatDoesNotDieAway) {
  EXPECT_THROW(CorrelationsOf(std::vector<double>{1.0}, 2), InputError);
}

// The colour that AIC found once in white noise, in a fit of 1201 samples: its slow noise is a
// third less than white noise has.
TEST(StampNoise, IsWhiteWhereItsColourMayBeChance) {
  const std::vector<double> chance = {
      0.013, -0.012, -0.037, -0.013, 0.008, -0.058, 0.031, -0.088, -0.045, 0.040, -0.049};
  EXPECT_TRUE(PlainestColour(chance, 1201).empty());
  // A hundred times the data and the same colour: no chance.
  EXPECT_EQ(PlainestColour(chance, 120100).size(), chance.size());
}

// Of an AR(1) over 1000 samples AIC takes more terms in a third of all draws.
TEST(StampNoise, KeepsTheOrderOfADrawnRecursion) {
  const int num_samples = 1000;
  const double rho = 0.8;
  RandomStream random(5, "stamp.noise.order");
  int with_one = 0, with_one_by_aic = 0;
  for (int run = 0; run < 200; ++run) {
    std::vector<double> noise(num_samples);
    double error = random.Normal();
    for (double& value : noise) {
      value = error;
      error = rho * error + std::sqrt(1.0 - rho * rho) * random.Normal();
    }
    const Autoregression by_aic = FitAutoregression({noise}, 20);
    with_one_by_aic += by_aic.order() == 1;
    with_one += PlainestColour(by_aic.coefficients, num_samples).size() == 1;
  }
  // BIC of this size asks for ln 1000 = 2.63^2: one more term in 1 % of draws.
  EXPECT_GE(with_one, 194);
  EXPECT_LT(with_one_by_aic, 160);
}

TEST(StampNoise, OfWhiteSamplesIsWhiteAndSmallerByTheRoot) {
  const StampNoise noise = MeansOf(0.03, {}, 9);
  EXPECT_EQ(noise.colour.order(), 0);
  EXPECT_NEAR(noise.velocity, 0.01, 1e-15);
}

// Means of three samples of an AR(1) with 0.7: variance (3 + 4 rho + 2 rho^2) / 9, covariance of
// neighbours rho (1 + rho + rho^2)^2 / 9.
TEST(StampNoise, OfMeansHasTheirVarianceAndCovariance) {
  const double rho = 0.7;
  const StampNoise noise = MeansOf(1.0, std::vector<double>{rho}, 3);
  const double variance = (3.0 + 4.0 * rho + 2.0 * rho * rho) / 9.0;
  const double neighbours = rho * std::pow(1.0 + rho + rho * rho, 2) / 9.0;
  EXPECT_NEAR(noise.velocity, std::sqrt(variance), 1e-8);
  ASSERT_EQ(noise.colour.order(), 1);
  EXPECT_NEAR(noise.colour.coefficients[0], neighbours / variance, 1e-8);
  EXPECT_NEAR(noise.colour.innovation_variance, 1.0 - std::pow(neighbours / variance, 2), 1e-8);
}

// Plain squares of a line through 200 samples, its height free as a start is, over drawn noise.
TEST(ColouredInformation, IsTheSpreadOfPlainSquaresOverDrawnNoise) {
  const int num_samples = 200, num_runs = 4000;
  const double rho = 0.8, deviation = 0.5;
  MotionDerivatives line;
  line.by_parameter = Eigen::VectorXd::LinSpaced(num_samples, 0.3, 2.9);
  line.by_start = Eigen::VectorXd::Ones(num_samples);
  const Eigen::MatrixXd information =
      InformationOf(line, MeansOf(deviation, std::vector<double>{rho}, 1));
  const Eigen::VectorXd centred = (line.by_parameter.array() - line.by_parameter.mean()).matrix();
  RandomStream random(3, "coloured.information");
  double squares = 0.0;
  for (int run = 0; run < num_runs; ++run) {
    double error = random.Normal(), estimate = 0.0;
    for (int i = 0; i < num_samples; ++i) {
      estimate += centred[i] * deviation * error;
      error = rho * error + std::sqrt(1.0 - rho * rho) * random.Normal();
    }
    estimate /= centred.squaredNorm();
    squares += estimate * estimate;
  }
  // Of a mean of squares: sqrt(2 / num_runs), 2.2 %.
  EXPECT_NEAR(squares / num_runs * information(0, 0), 1.0, 4.0 * std::sqrt(2.0 / num_runs));
}

TEST(ColouredInformation, GivesNothingToWhatLeavesNoTrace) {
  MotionDerivatives derivatives;
  derivatives.by_parameter.setZero(50, 2);
  derivatives.by_parameter.col(0) = Eigen::VectorXd::LinSpaced(50, -1.0, 1.0);
  derivatives.by_start = Eigen::VectorXd::Ones(50);
  const Eigen::MatrixXd information =
      InformationOf(derivatives, MeansOf(0.1, std::vector<double>{0.5}, 1));
  EXPECT_GT(information(0, 0), 0.0);
  EXPECT_EQ(information(1, 1), 0.0);
}

}  // namespace
}  // namespace fathom
