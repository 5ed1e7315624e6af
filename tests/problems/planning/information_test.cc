// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/information.h"

#include "fathom/vehicle/parameters.h"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// A model's velocity with one parameter changed.
double VelocityWith(int parameter, double change, double stamp, const HeldCommand& command) {
  UncoupledModel<double> model = {50.0, 30.0, 8.0, 1.5};
  ParameterVector values = ToVector(model);
  values[parameter] += change;
  const std::vector<double> stamps = {0.1, stamp};
  return MotionUnder({ModelFromVector(values)}, Dof::kSurge, command, stamps)->velocity.back();
}

TEST(Information, IsThatOfTheWholeProblemLessTheStart) {
  const HeldCommand command = {{0.0, 3.0, 7.0}, {20.0, -15.0, 5.0}};
  const std::vector<double> stamps = PlannedStamps(10.0, 0.25);
  MotionDerivatives derivatives;
  ASSERT_TRUE(MotionUnder({{50.0, 30.0, 8.0, 1.5}}, Dof::kSurge, command, stamps, &derivatives));
  ASSERT_EQ(derivatives.by_parameter.cols(), 4);
  ASSERT_EQ(derivatives.by_start.cols(), 1);

  // The columns against central differences.
  for (int parameter = 0; parameter < 4; ++parameter) {
    const double h = 1e-4;
    const double slope =
        (VelocityWith(parameter, h, 10.0, command) - VelocityWith(parameter, -h, 10.0, command)) /
        (2.0 * h);
    EXPECT_NEAR(derivatives.by_parameter(39, parameter), slope, 1e-6 + 1e-4 * std::abs(slope));
  }

  // The covariance of the parameters is a block of that of all unknowns together.
  Eigen::MatrixXd all(stamps.size(), 5);
  all << derivatives.by_parameter, derivatives.by_start;
  const double noise = 0.02;
  const Eigen::MatrixXd covariance = (all.transpose() * all / (noise * noise)).inverse();
  const Eigen::MatrixXd information = InformationOf(derivatives, noise);
  const Eigen::MatrixXd inverse = InverseOf(information);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(inverse(i, i) / covariance(i, i), 1.0, 1e-6);
  }

  // In sizes of which the third parameter has the widest interval.
  Eigen::Vector4d sizes = covariance.diagonal().head(4).cwiseSqrt() * 10.0;
  sizes[2] *= 0.5;
  EXPECT_NEAR(
      WorthOfInformation(information, sizes),
      std::log(information.determinant()) + 2.0 * sizes.array().log().sum() - std::log(0.04),
      1e-6);
}

TEST(Information, OfASingularMatrixIsNone) {
  const Eigen::MatrixXd singular = Eigen::MatrixXd::Ones(2, 2) * 0.0;
  EXPECT_EQ(WorthOfInformation(singular, Eigen::Vector2d::Ones()),
            -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isinf(InverseOf(singular)(0, 0)));
}

}  // namespace
}  // namespace fathom
