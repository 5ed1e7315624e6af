// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/identification_text.h"

#include <cmath>
#include <limits>
#include <random>

#include "handmade_identification.h"
#include <Eigen/Cholesky>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(RatioOf, MatchesTheDeltaMethodByHand) {
  const auto row = HandmadeRow(Family::kOutputError, 0.02, 0.03);
  const Ratio ratio = RatioOf(row.fitted, kLinearDamping, kInertia);
  EXPECT_DOUBLE_EQ(ratio.value, 5.0 / 40.0);
  // Gradient 1/40 by d_L and -0.125/40 by m:
  // 0.025^2 0.25 + 0.003125^2 4 + 2 (0.025) (-0.003125) (-0.6) = 2.890625e-4.
  EXPECT_NEAR(ratio.std, std::sqrt(2.890625e-4), 1e-15);
}

TEST(RatioOf, MatchesAMonteCarlo) {
  FittedModel fitted;
  fitted.model = {
      .inertia = 12.0, .quadratic_damping = 7.0, .linear_damping = 3.0, .buoyancy = 0.4};
  // A full covariance, L L' with standard deviations of about 1 % of the values.
  Eigen::Matrix4d factor;
  factor << 0.12, 0, 0, 0, -0.04, 0.06, 0, 0, 0.02, -0.01, 0.02, 0, 0.01, 0.02, -0.01, 0.03;
  fitted.covariance = factor * factor.transpose();
  const Ratio ratio = RatioOf(fitted, kQuadraticDamping, kInertia);

  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  const int num_draws = 200000;
  double sum = 0.0, sum_of_squares = 0.0;
  for (int i = 0; i < num_draws; ++i) {
    Eigen::Vector4d e;
    for (int k = 0; k < 4; ++k) e[k] = normal(generator);
    const Eigen::Vector4d p = ToVector(fitted.model) + factor * e;
    const double difference = p[kQuadraticDamping] / p[kInertia] - ratio.value;
    sum += difference;
    sum_of_squares += difference * difference;
  }
  const double mean = sum / num_draws;
  const double spread = std::sqrt(sum_of_squares / num_draws - mean * mean);
  // A standard deviation of n draws is known to 1 / sqrt(2 n); the delta method's own error is of
  // the order of the square of the relative deviation, 1e-4.
  EXPECT_NEAR(ratio.std / spread, 1.0, 4.0 / std::sqrt(2.0 * num_draws) + 5e-4);
}

// The reason why ratios are printed: a scale that all parameters share drops out.
TEST(RatioOf, IsFreeOfAnUnknownThrust) {
  FittedModel fitted;
  fitted.model = {
      .inertia = 12.0, .quadratic_damping = 7.0, .linear_damping = 3.0, .buoyancy = 0.4};
  const ParameterVector p = ToVector(fitted.model);
  fitted.covariance = 0.3 * 0.3 * p * p.transpose();
  EXPECT_NEAR(RatioOf(fitted, kLinearDamping, kInertia).std, 0.0, 1e-9);
  EXPECT_NEAR(RatioOf(fitted, kQuadraticDamping, kInertia).std, 0.0, 1e-9);
}

TEST(FormatIdentification, ShowsParametersIntervalsFiguresAndCaveats) {
  auto row = HandmadeRow(Family::kOutputError, 0.02, 0.03);
  row.fitted.caveats = {"The log cannot tell them apart."};
  // 40 -+ 1.96 2, 30 -+ 1.96 1.5
  EXPECT_THAT(FormatIdentification(row),
              AllOf(HasSubstr("surge by output error from velocity.csv: "),
                    HasSubstr("36.1 ... 43.9"),
                    HasSubstr("27.1 ... 32.9"),
                    HasSubstr("velocity MAE 0.01000 m/s, velocity NMAE 0.0200   (90 samples, 9 s)"),
                    HasSubstr("velocity MAE 0.00750 m/s, velocity NMAE 0.0300   (40 samples, 4 s)"),
                    HasSubstr("note: The log cannot tell them apart."),
                    Not(HasSubstr("/ inertia"))));
}

TEST(FormatIdentification, CutsTheIntervalOfADampingAtZero) {
  auto row = HandmadeRow(Family::kOutputError, 0.02, 0.03);
  row.fitted.model.linear_damping = 0.5;  // 0.5 - 1.96 0.5 < 0
  EXPECT_THAT(FormatIdentification(row), HasSubstr("0.00 ... 1.48"));
}

TEST(FormatIdentification, GivesRatiosWhereTheForceHasNoSiUnit) {
  auto row = HandmadeRow(Family::kOutputError, 0.02, 0.03);
  row.fitted.force_unit = "A";
  // 0.125 -+ 1.96 sqrt(2.890625e-4), by hand above; 0.75 -+ 1.96 sqrt(0.025^2 2.25 + 0.01875^2 4)
  EXPECT_THAT(FormatIdentification(row),
              AllOf(HasSubstr("linear_damping / inertia"),
                    HasSubstr("0.092 ... 0.158"),
                    HasSubstr("quadratic_damping / inertia"),
                    HasSubstr("0.646 ... 0.854"),
                    HasSubstr("The command is in A, not in N")));
}

// Least squares may find a negative damping: its interval must hold it.
TEST(FormatIdentification, TheIntervalOfANegativeDampingIsNotCutAtZero) {
  auto row = HandmadeRow(Family::kLeastSquares, 0.02, 0.03);
  row.fitted.model.linear_damping = -5.0;  // +- 1.96 x 0.5
  EXPECT_THAT(FormatIdentification(row), HasSubstr("-5.98 ... -4.02"));
}

TEST(FormatIdentification, NamesTheFileAndShowsUnitsWithRaisedFigures) {
  auto row = HandmadeRow(Family::kOutputError, 0.02, 0.03);
  row.fitted.dof = Dof::kYaw;
  row.fitted.force_unit = "N m";
  EXPECT_THAT(FormatIdentification(row, "run.csv"),
              AllOf(HasSubstr("yaw by output error from run.csv: "),
                    HasSubstr(" kg m²/s "),
                    Not(HasSubstr("^"))));
}

TEST(FormatIdentification, SaysBelowTheTableWhatItsFiguresMean) {
  auto row = HandmadeRow(Family::kOutputError, 0.02, 0.03);
  row.condition_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(FormatIdentification(row),
              AllOf(HasSubstr("\n±: one standard deviation\n"), Not(HasSubstr("condition"))));
  row.condition_number = 10.0;
  EXPECT_THAT(
      FormatIdentification(row),
      HasSubstr("±: one standard deviation; unique effect: the part that no other parameter can "
                "imitate\ncondition number 10.0 (1: the parameters act unlike each other; above "
                "30: some act almost alike)\n"));
}

TEST(FormatIdentification, AnUnusableResultShowsTheReasonAndNoNumbers) {
  EXPECT_EQ(FormatIdentification(UnusableRow(Family::kAdaptive)),
            "surge by adaptive from velocity.csv: the command never changes\n");
}

}  // namespace
}  // namespace fathom
