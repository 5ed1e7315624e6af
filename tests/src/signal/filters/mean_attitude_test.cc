// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/mean_attitude.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

using Attitudes = std::vector<Eigen::Quaterniond>;

Eigen::Quaterniond Turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

const Eigen::Quaterniond kTruth = Turn(1.9, {0.3, -0.8, 0.4});

TEST(MeanAttitude, IsThatOfAVehicleThatHolds) {
  for (const Dof dof : kAllDofs) {
    EXPECT_LT(MeanAttitude(dof, Attitudes(7, kTruth)).angularDistance(kTruth), 1e-12) << Name(dof);
    EXPECT_LT(AxisTurn(dof, Attitudes(7, kTruth)), 1e-7) << Name(dof);
  }
}

TEST(MeanAttitude, IsNotPulledAlongByFlips) {
  std::mt19937 generator(4);
  std::normal_distribution<double> normal;
  Attitudes all;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d wander(normal(generator), normal(generator), normal(generator));
    Eigen::Quaterniond q = kTruth * Turn(0.01 * wander.norm(), wander);
    if (i % 20 == 0) q = q * Turn(0.8, {0.0, 1.0, 0.0});
    all.push_back(q);
  }
  // Its own error is 0.01 / sqrt(2000) about each axis, 1.25 times that of a mean; the flips weigh
  // as half a step of rank in twenty: 0.06 of the wander. The mean would be off by 0.04.
  EXPECT_LT(MeanAttitude(Dof::kSurge, all).angularDistance(kTruth), 0.002);
}

TEST(MeanAttitude, IsTheWorldsWhereItIsAsNearAsNoise) {
  const Eigen::Quaterniond level = Turn(M_PI / 2.0, {0.0, 0.0, 1.0});
  for (const Dof dof : kAllDofs) {
    const Attitudes near(5, level * Turn(0.004, {0.5, -1.0, 0.7}));
    EXPECT_LT(MeanAttitude(dof, near).angularDistance(level), 1e-12) << Name(dof);
    const Attitudes oblique(5, level * Turn(0.01, {0.5, -1.0, 0.7}));
    EXPECT_LT(MeanAttitude(dof, oblique).angularDistance(oblique[0]), 0.005) << Name(dof);
  }
  // Heading obliquely, but level: heave is along the world's vertical.
  const Attitudes oblique(5, Turn(0.4, {0.0, 0.0, 1.0}) * Turn(0.003, {1.0, 0.0, 0.0}));
  const Eigen::Vector3d down = MeanAttitude(Dof::kHeave, oblique) * Eigen::Vector3d::UnitZ();
  EXPECT_EQ(down, Eigen::Vector3d::UnitZ());
}

TEST(MeanAttitude, KeepsTheAxisThatAVehicleTurnsAbout) {
  Attitudes all;
  for (int i = 0; i <= 1000; ++i) all.push_back(kTruth * Turn(0.05 * i, {0.0, 0.0, 1.0}));
  const Eigen::Quaterniond mean = MeanAttitude(Dof::kYaw, all);
  const Eigen::Vector3d axis = kTruth * Eigen::Vector3d::UnitZ();
  EXPECT_LT((mean * Eigen::Vector3d::UnitZ() - axis).norm(), 1e-9);
  EXPECT_NEAR(mean.norm(), 1.0, 1e-12);
}

TEST(AxisTurn, IsTheRootMeanSquareOfTheAngle) {
  Attitudes all;
  for (int i = 0; i < 400; ++i) {
    all.push_back(kTruth * Turn(0.2 * std::sin(0.1 * M_PI * i), {0.0, 0.0, 1.0}));
  }
  EXPECT_NEAR(AxisTurn(Dof::kSurge, all), 0.2 / std::sqrt(2.0), 1e-3);
  EXPECT_LT(AxisTurn(Dof::kHeave, all), 1e-7);
}

}  // namespace
}  // namespace fathom
