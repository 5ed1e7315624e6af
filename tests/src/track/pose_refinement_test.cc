// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/pose_refinement.h"

#include <limits>
#include <vector>

#include "synthetic_views.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<SeenCorner> CornersSeenFrom(const Pose& world_from_camera) {
  const MarkerMap map = FourMarkers();
  std::vector<SeenCorner> corners;
  for (const Detection& one : ObserveCorners(SyntheticCamera(), map, world_from_camera)) {
    for (const SeenCorner& corner : SeenCornersOf(*map.Find(one.tag_id), one)) {
      corners.push_back(corner);
    }
  }
  return corners;
}

TEST(PoseRefinement, ErrorIsZeroAtTheTruthAndThatOfAShiftBesideIt) {
  const Pose truth = CameraPoseAt(1.2, 0.3);
  auto corners = CornersSeenFrom(truth);
  ASSERT_EQ(corners.size(), 16u);
  EXPECT_LT(SquaredError(SyntheticCamera(), corners, truth), 1e-18);
  for (SeenCorner& corner : corners) corner.pixel += Eigen::Vector2d(3.0, -4.0);
  EXPECT_NEAR(SquaredError(SyntheticCamera(), corners, truth), 16.0 * 25.0, 1e-9);
}

TEST(PoseRefinement, ErrorIsInfiniteWithACornerBehindTheCamera) {
  const auto corners = CornersSeenFrom(CameraPoseAt(1.2, 0.3));
  Pose beyond = CameraPoseAt(1.2, 0.3);
  beyond.translation.x() += 10.0;
  EXPECT_EQ(SquaredError(SyntheticCamera(), corners, beyond), kInfinity);
}

TEST(PoseRefinement, FindsTheTruthFromNearby) {
  const Pose truth = CameraPoseAt(1.2, 0.3);
  PoseIncrement step;
  step << 0.2, -0.1, 0.15, 0.05, -0.08, 0.03;
  const auto refined =
      RefinePose(SyntheticCamera(), CornersSeenFrom(truth), Moved(truth, step), kInfinity);
  ASSERT_TRUE(refined);
  EXPECT_LT(StepBetween(refined->world_from_camera, truth).norm(), 1e-8);
}

// With Huber's loss a corner that is far off pulls no more than one at the loss's bend does, 300
// times less.
TEST(PoseRefinement, HoldsBackACornerBeyondTheLoss) {
  const Pose truth = CameraPoseAt(1.2, 0.3);
  auto corners = CornersSeenFrom(truth);
  corners[5].pixel.x() += 30.0;
  const auto error = [&](double huber) {
    const auto refined = RefinePose(SyntheticCamera(), corners, truth, huber);
    return refined ? StepBetween(refined->world_from_camera, truth).norm() : kInfinity;
  };
  EXPECT_LT(error(0.1), 0.01 * error(kInfinity));
}

TEST(PoseRefinement, FindsNoneWhereTheCornersLeaveThePoseOpen) {
  auto corners = CornersSeenFrom(CameraPoseAt(1.2, 0.3));
  corners.resize(2);
  EXPECT_FALSE(RefinePose(SyntheticCamera(), corners, CameraPoseAt(1.2, 0.3), kInfinity));
}

}  // namespace
}  // namespace fathom
