// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/information_share.h"

#include "fathom/base/random_stream.h"

#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// A full covariance, with units that are far apart.
Eigen::MatrixXd SomeCovariance(std::uint64_t seed, double size) {
  RandomStream random(seed, "covariance");
  Eigen::MatrixXd root(4, 4);
  for (Eigen::Index i = 0; i < 16; ++i) root(i / 4, i % 4) = random.Normal();
  const Eigen::Vector4d unit(1e3, 1e-2, 7.0, 1e-5);
  return size * (unit.asDiagonal() * root * root.transpose() * unit.asDiagonal());
}

TEST(InformationShare, OfIndependentParametersGoesByTheInverseVariance) {
  const Eigen::MatrixXd first = Eigen::Vector2d(1.0, 9.0).asDiagonal();
  const Eigen::MatrixXd second = Eigen::Vector2d(3.0, 4.5).asDiagonal();
  const auto shared = ShareInformation(std::vector{first, second});
  ASSERT_TRUE(shared);
  EXPECT_NEAR(shared->share(0, 0), 0.75, 1e-12);
  EXPECT_NEAR(shared->share(1, 0), 0.25, 1e-12);
  EXPECT_NEAR(shared->share(0, 1), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(shared->covariance(0, 0), 0.75, 1e-12);  // 1 / (1 + 1/3)
}

TEST(InformationShare, AddsUpToOne) {
  const auto shared = ShareInformation(
      std::vector{SomeCovariance(1, 1.0), SomeCovariance(2, 5.0), SomeCovariance(3, 0.2)});
  ASSERT_TRUE(shared);
  for (Eigen::Index p = 0; p < 4; ++p) EXPECT_NEAR(shared->share.col(p).sum(), 1.0, 1e-6);
  EXPECT_GE(shared->share.minCoeff(), 0.0);
}

// A log that is cut in three equal parts: each has a third, and three times the variance.
TEST(InformationShare, IsEqualOfEqualLogs) {
  const Eigen::MatrixXd third = SomeCovariance(4, 3.0);
  const auto shared = ShareInformation(std::vector{third, third, third});
  ASSERT_TRUE(shared);
  EXPECT_NEAR((shared->share.array() - 1.0 / 3.0).abs().maxCoeff(), 0.0, 1e-9);
  EXPECT_TRUE(shared->covariance.isApprox(third / 3.0, 1e-9));
}

TEST(InformationShare, IsNothingOfAParameterWithoutAnInterval) {
  const Eigen::MatrixXd open = Eigen::Vector2d(1.0, 0.0).asDiagonal();
  const Eigen::MatrixXd known = Eigen::Vector2d(1.0, 2.0).asDiagonal();
  EXPECT_FALSE(ShareInformation(std::vector{known, open}));
  EXPECT_FALSE(ShareInformation({}));
}

}  // namespace
}  // namespace fathom
