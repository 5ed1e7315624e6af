// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/covariance_factor.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Of unlike units, and singular: the third number is the second less a thousand of the first.
TEST(CovarianceFactor, TimesItsTransposeIsTheCovariance) {
  Eigen::Matrix<double, 3, 2> mix;
  mix << 1e-3, 0.0, 2.0, 5.0, 1.0, 5.0;
  const Eigen::MatrixXd covariance = mix * mix.transpose();
  const Eigen::MatrixXd factor = CovarianceFactor(covariance);
  const Eigen::MatrixXd product = factor * factor.transpose();
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      // Rounding of a number of the size of both deviations.
      const double size = std::sqrt(covariance(i, i) * covariance(j, j));
      EXPECT_NEAR(product(i, j), covariance(i, j), 1e-14 * size) << i << ' ' << j;
    }
  }
}

// Of a model whose numbers are all held.
TEST(CovarianceFactor, OfNothingIsNothing) {
  EXPECT_EQ(CovarianceFactor(Eigen::MatrixXd(0, 0)).size(), 0);
}

}  // namespace
}  // namespace fathom
