// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/deviated_pose.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

const Pose kSimulated = {
    Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.5, 0.8).normalized())),
    {1.3, -0.7, 0.4}};
const std::array<double, 6> kDeviation = {0.21, -0.13, 0.17, 0.31, -0.24, 0.19};

constexpr double kStep = 1e-6;
constexpr double kClose = 1e-8;  // of central differences over such steps of numbers of about 1

TEST(DeviatedPose, IsTheSimulatedOneThenAMoveAlongTheBodysAxes) {
  const Pose turned = {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ())),
                       {5.0, 6.0, 7.0}};
  const DeviatedPose pose = Deviated(turned, {2.0, 0.0, 0.0, 0.0, 0.0, 0.3});
  // Ahead of a vehicle that looks along y is y.
  EXPECT_LT((pose.world_from_body.translation - Eigen::Vector3d(5.0, 8.0, 7.0)).norm(), 1e-12);
  const Eigen::Quaterniond expected(Eigen::AngleAxisd(M_PI / 2 + 0.3, Eigen::Vector3d::UnitZ()));
  EXPECT_LT(pose.world_from_body.rotation.angularDistance(expected), 1e-7);
}

TEST(DeviatedPose, KnowsHowItMovesWithBoth) {
  const DeviatedPose at = Deviated(kSimulated, kDeviation);
  for (int i = 0; i < 6; ++i) {
    PoseIncrement step = PoseIncrement::Zero();
    step[i] = kStep;
    const PoseIncrement by_simulated =
        (StepBetween(at.world_from_body,
                     Deviated(Moved(kSimulated, step), kDeviation).world_from_body) -
         StepBetween(at.world_from_body,
                     Deviated(Moved(kSimulated, -step), kDeviation).world_from_body)) /
        (2.0 * kStep);
    EXPECT_LT((by_simulated - at.by_simulated.col(i)).norm(), kClose) << i;
    auto more = kDeviation, less = kDeviation;
    more[static_cast<std::size_t>(i)] += kStep;
    less[static_cast<std::size_t>(i)] -= kStep;
    const PoseIncrement by_deviation =
        (StepBetween(at.world_from_body, Deviated(kSimulated, more).world_from_body) -
         StepBetween(at.world_from_body, Deviated(kSimulated, less).world_from_body)) /
        (2.0 * kStep);
    EXPECT_LT((by_deviation - at.by_deviation.col(i)).norm(), kClose) << i;
  }
}

TEST(DeviatedPose, FindsTheDeviationBack) {
  const auto found = DeviationBetween(kSimulated, Deviated(kSimulated, kDeviation).world_from_body);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], kDeviation[i], 1e-12) << i;
}

TEST(TurnJacobian, IsContinuousWhereItsFormulaChanges) {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.2, -0.6, 0.7).normalized();
  EXPECT_LT((TurnJacobian(0.99e-4 * axis) - TurnJacobian(1.01e-4 * axis)).norm(), 2e-6);
}

}  // namespace
}  // namespace fathom
