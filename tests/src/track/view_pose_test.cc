// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/view_pose.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "synthetic_views.h"
#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace fathom {
namespace {

double DistanceBetween(const Pose& a, const Pose& b) { return StepBetween(a, b).norm(); }

TEST(SolveSquare, FindsTheTruthFromPerfectCorners) {
  const MarkerMap map = SingleMarker();
  const Pose world_from_camera = CameraPoseAt(1.7, 0.4);
  const auto detections = ObserveCorners(SyntheticCamera(), map, world_from_camera);
  ASSERT_EQ(detections.size(), 1u);
  const auto poses = SolveSquare(SyntheticCamera(), 0.4, detections[0].corners);
  ASSERT_GE(poses.size(), 1u);
  const Pose truth = world_from_camera.Inverse() * map.markers[0].world_from_tag;
  EXPECT_LT(DistanceBetween(poses[0], truth), 1e-8);
}

// Far away, the wrong solution is the right one tilted to the other side of the line of sight.
TEST(SolveSquare, FindsBothSolutionsOfADistantSquare) {
  CameraModel camera = SyntheticCamera();
  camera.lens = LensModel::kNone;
  camera.coefficients = {};
  constexpr double kTilt = 0.5;
  const Pose truth = {Eigen::Quaterniond(Eigen::AngleAxisd(kTilt, Eigen::Vector3d::UnitY())),
                      {0.0, 0.0, 12.0}};
  const Pose mirrored = {Eigen::Quaterniond(Eigen::AngleAxisd(-kTilt, Eigen::Vector3d::UnitY())),
                         {0.0, 0.0, 12.0}};
  std::array<Eigen::Vector2d, 4> corners;
  for (int i = 0; i < 4; ++i) corners[i] = Project<double>(camera, truth * CornersInTag(0.4)[i]);
  const auto poses = SolveSquare(camera, 0.4, corners);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_LT(DistanceBetween(poses[0], truth), 1e-6);
  // 0.4 m at 12 m: perspective is a thirtieth of it, and so is what parts the two.
  EXPECT_LT(DistanceBetween(poses[1], mirrored), 0.1);
  EXPECT_GT(DistanceBetween(poses[1], truth), 0.8);
}

TEST(SolveSquare, FindsNothingInCornersThatAreNoSquare) {
  const std::array<Eigen::Vector2d, 4> point = {Eigen::Vector2d(600, 400),
                                                Eigen::Vector2d(600, 400),
                                                Eigen::Vector2d(600, 400),
                                                Eigen::Vector2d(600, 400)};
  EXPECT_TRUE(SolveSquare(SyntheticCamera(), 0.4, point).empty());
  const std::array<Eigen::Vector2d, 4> far_out = {Eigen::Vector2d(1e7, 1e7),
                                                  Eigen::Vector2d(2e7, 1e7),
                                                  Eigen::Vector2d(2e7, 0),
                                                  Eigen::Vector2d(1e7, 0)};
  EXPECT_TRUE(SolveSquare(SyntheticCamera(), 0.4, far_out).empty());
}

// A frame of four markers leaves one pose, and its covariance is the spread of repeated runs:
// chi-square of 6 degrees of freedom has mean 6 and variance 12.
TEST(SolveView, CovarianceMatchesTheSpreadOverRepeatedRuns) {
  constexpr double kSigma = 0.3;
  constexpr int kNumRuns = 500;
  for (const MarkerMap& map : {SingleMarker(), FourMarkers()}) {
    const Pose truth = CameraPoseAt(2.0, 0.6);
    const auto ideal = ObserveCorners(SyntheticCamera(), map, truth);
    ASSERT_EQ(ideal.size(), map.markers.size());
    std::mt19937 random(11);
    double sum_of_squares = 0.0, sum_of_errors = 0.0;
    for (int run = 0; run < kNumRuns; ++run) {
      auto frame = ideal;
      AddNoise(kSigma, &random, &frame);
      const auto poses = SolveView(SyntheticCamera(), map, frame);
      ASSERT_GE(poses.size(), 1u);
      // Of the two, the one that is not flipped.
      const auto nearest =
          std::min_element(poses.begin(), poses.end(), [&](const auto& a, const auto& b) {
            return DistanceBetween(a.world_from_camera, truth) <
                   DistanceBetween(b.world_from_camera, truth);
          });
      ASSERT_EQ(nearest->used.size(), map.markers.size());
      ASSERT_EQ(nearest->degrees_of_freedom, 8 * static_cast<int>(map.markers.size()) - 6);
      const PoseIncrement error = StepBetween(nearest->world_from_camera, truth);
      sum_of_squares += error.dot(nearest->unit_covariance.ldlt().solve(error)) / (kSigma * kSigma);
      sum_of_errors += nearest->squared_error / (kSigma * kSigma) / nearest->degrees_of_freedom;
    }
    EXPECT_NEAR(sum_of_squares / kNumRuns, 6.0, 5.0 * std::sqrt(12.0 / kNumRuns));
    EXPECT_NEAR(sum_of_errors / kNumRuns,
                1.0,
                5.0 * std::sqrt(2.0 / (8.0 * map.markers.size() - 6.0) / kNumRuns));
  }
}

TEST(SolveView, LeavesOutADetectionThatContradictsTheOthers) {
  const MarkerMap map = FourMarkers();
  const Pose truth = CameraPoseAt(2.0, 0.3);
  auto frame = ObserveCorners(SyntheticCamera(), map, truth);
  ASSERT_EQ(frame.size(), 4u);
  for (Eigen::Vector2d& corner : frame[2].corners) corner.x() += 30.0;
  const auto poses = SolveView(SyntheticCamera(), map, frame, {.gate = 5.0});
  ASSERT_GE(poses.size(), 1u);
  EXPECT_EQ(poses[0].used, (std::vector<int>{0, 1, 3}));
  EXPECT_LT(DistanceBetween(poses[0].world_from_camera, truth), 1e-7);
}

// Where corners are quiet the gate is narrow, so that a single square does not tell where the
// others are to within it, and a fit that holds the wild detection misses all of them.
TEST(SolveView, KeepsTheQuietMarkersNextToAWildOne) {
  constexpr double kSigma = 0.05;  // [px]
  constexpr int kNumSeeds = 100;
  for (const size_t num_markers : {4, 3}) {
    MarkerMap map = FourMarkers();
    map.markers.resize(num_markers);
    for (int wild = 0; wild < static_cast<int>(num_markers); ++wild) {
      std::vector<int> others;
      for (int i = 0; i < static_cast<int>(num_markers); ++i) {
        if (i != wild) others.push_back(i);
      }
      int num_kept = 0;
      for (int seed = 0; seed < kNumSeeds; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        const Pose truth = CameraPoseAt(0.37 * seed, 0.3 * std::sin(1.0 * seed));
        auto frame = ObserveCorners(SyntheticCamera(), map, truth);
        ASSERT_EQ(frame.size(), num_markers);
        AddNoise(kSigma, &random, &frame);
        // Half of them so near that they count as perhaps seen by every pose to start with.
        PutElsewhere(seed % 2 == 0 ? 120.0 : 2000.0, &random, &frame[wild]);
        // Gate and loss as TrackPoses() sets them.
        const auto poses =
            SolveView(SyntheticCamera(), map, frame, {.gate = 4.0 * kSigma, .huber = 3.0 * kSigma});
        if (poses.empty() || poses[0].used != others) continue;
        ++num_kept;
        // Chi-square of 6 degrees of freedom: one in two million is above 40.
        const PoseIncrement error = StepBetween(poses[0].world_from_camera, truth);
        EXPECT_LT(error.dot(poses[0].unit_covariance.ldlt().solve(error)) / (kSigma * kSigma), 40.0)
            << num_markers << " markers, wild " << wild << ", seed " << seed;
      }
      EXPECT_EQ(num_kept, kNumSeeds) << num_markers << " markers, wild " << wild;
    }
  }
}

}  // namespace
}  // namespace fathom
