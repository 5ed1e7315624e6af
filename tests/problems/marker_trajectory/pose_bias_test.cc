// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/pose_bias.h"

#include "fathom/marker_trajectory/bundle_adjustment.h"

#include <cmath>
#include <random>
#include <vector>

#include "synthetic_views.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Four markers of 0.4 and 0.25 m, as data/films/wall_four_tags.yaml has them.
MarkerMap WideMarkers() {
  MarkerMap map = FourMarkers();
  int i = 0;
  for (Marker& marker : map.markers) {
    marker.size = i % 2 == 0 ? 0.4 : 0.25;
    marker.world_from_tag.translation.y() *= 0.4 / 0.6;
    marker.world_from_tag.translation.z() *= 0.35 / 0.4;
    ++i;
  }
  return map;
}

// The camera looks straight at the wall from so far away [m], turned by `tilt` [rad] about its
// vertical and moved aside so that it still sees the markers.
Pose LookingAtTheWall(double distance, double tilt) {
  Pose pose = OnTheWall(-distance * std::sin(tilt), 0.0);
  pose.translation.x() = 3.0 - distance * std::cos(tilt);
  pose.rotation = pose.rotation * Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY());
  return pose;
}

std::vector<int> IdsOf(const MarkerMap& map) {
  std::vector<int> ids;
  for (const Marker& marker : map.markers) ids.push_back(marker.id);
  return ids;
}

// The errors of independent fits.
struct Scatter {
  PoseIncrement mean = PoseIncrement::Zero();
  PoseIncrement std_of_mean = PoseIncrement::Zero();
  PoseCovariance first_order = PoseCovariance::Zero();  // of one fit
};

Scatter ScatterOfFits(const MarkerMap& map, const Pose& truth, double sigma, int num_fits) {
  std::vector<Detection> detections;
  std::vector<AdjustedFrame> frames;
  for (int i = 0; i < num_fits; ++i) {
    AdjustedFrame frame = {truth, {}};
    for (const Detection& one : ObserveCorners(SyntheticCamera(), map, truth, i)) {
      frame.detections.push_back(static_cast<int>(detections.size()));
      detections.push_back(one);
    }
    frames.push_back(frame);
  }
  const BundleAdjustmentOptions options = {.corner_sigma = sigma};
  const auto exact = AdjustBundle(SyntheticCamera(), map, {}, detections, frames, options);
  std::mt19937 random(17);
  AddNoise(sigma, &random, &detections);
  const auto found = AdjustBundle(SyntheticCamera(), map, {}, detections, frames, options);
  EXPECT_TRUE(found.is_usable) << found.message;
  Scatter scatter;
  PoseIncrement squares = PoseIncrement::Zero();
  for (const Pose& pose : found.world_from_camera) {
    const PoseIncrement error = StepBetween(truth, pose);
    scatter.mean += error / num_fits;
    squares += error.cwiseAbs2() / num_fits;
  }
  scatter.std_of_mean = ((squares - scatter.mean.cwiseAbs2()) / num_fits).cwiseSqrt();
  scatter.first_order = exact.pose_covariance.front() * std::pow(sigma / exact.corner_sigma, 2);
  return scatter;
}

// Every coordinate, within four of the mean's standard deviations and a fifth of the bias itself:
// what is left is of fourth order in the noise.
TEST(BiasOfPose, IsTheMeanErrorOfManyFits) {
  struct Case {
    MarkerMap map;
    double distance, tilt, sigma;
    bool is_seen;  // whether so many fits tell it from nothing
  };
  for (const Case& one : {Case{SingleMarker(), 2.5, 0.0, 0.3, true},
                          Case{SingleMarker(), 4.0, 0.0, 0.1, true},
                          Case{SingleMarker(), 3.0, 0.2, 0.3, false},
                          Case{WideMarkers(), 7.0, 0.0, 0.3, true},
                          Case{WideMarkers(), 3.0, 0.3, 0.3, false}}) {
    SCOPED_TRACE(testing::Message() << one.map.markers.size() << " markers at " << one.distance
                                    << " m, " << one.tilt << " rad, " << one.sigma << " px");
    const Pose truth = LookingAtTheWall(one.distance, one.tilt);
    const Scatter scatter = ScatterOfFits(one.map, truth, one.sigma, 2000);
    const PoseIncrement bias =
        BiasOfPose(SyntheticCamera(), one.map, IdsOf(one.map), truth, one.sigma);
    for (int k = 0; k < 6; ++k) {
      EXPECT_NEAR(bias[k], scatter.mean[k], 4.0 * scatter.std_of_mean[k] + 0.2 * std::abs(bias[k]))
          << k;
    }
    EXPECT_EQ(std::abs(scatter.mean[0]) > 6.0 * scatter.std_of_mean[0], one.is_seen);
  }
}

// docs/marker_trajectory.md (3): 3/4 d s^2 towards a single marker seen face on.
TEST(BiasOfPose, IsTheClosedFormFaceOn) {
  constexpr double kDistance = 3.0, kSigma = 0.03;
  const Pose truth = LookingAtTheWall(kDistance, 0.0);
  const PoseCovariance covariance = ScatterOfFits(SingleMarker(), truth, kSigma, 2).first_order;
  const PoseIncrement bias =
      BiasOfPose(SyntheticCamera(), SingleMarker(), std::vector<int>{0}, truth, kSigma);
  const double closed_form = 0.75 * kDistance * (covariance(3, 3) + covariance(4, 4));
  EXPECT_NEAR(bias[0], closed_form, 0.05 * closed_form);
}

// Where noise of second order would have the camera metres off, as Monte Carlo has it.
TEST(BiasOfPose, DoesNotGrowBeyondWhatTheCornersAllow) {
  for (const double distance : {4.5, 6.0, 8.0}) {
    const Pose truth = LookingAtTheWall(distance, 0.0);
    const Scatter scatter = ScatterOfFits(SingleMarker(), truth, 0.3, 1000);
    const PoseIncrement bias =
        BiasOfPose(SyntheticCamera(), SingleMarker(), std::vector<int>{0}, truth, 0.3);
    EXPECT_NEAR(bias[0], scatter.mean[0], 4.0 * scatter.std_of_mean[0] + 0.05 * scatter.mean[0])
        << distance;
  }
}

TEST(BiasOfPose, IsNothingWithoutNoiseAndWhereTheCornersTellNothing) {
  const Pose truth = LookingAtTheWall(3.0, 0.0);
  const std::vector<int> ids = {0};
  EXPECT_EQ(BiasOfPose(SyntheticCamera(), SingleMarker(), ids, truth, 0.0).norm(), 0.0);
  // Noise as large as the image puts corners behind the camera.
  EXPECT_EQ(BiasOfPose(SyntheticCamera(), SingleMarker(), ids, truth, 1000.0).norm(), 0.0);
  EXPECT_EQ(BiasOfPose(SyntheticCamera(), SingleMarker(), {}, truth, 0.3).norm(), 0.0);
}

// A camera that stands still far off: the noise of the poses is as it was, their mean is not.
TEST(RemoveBias, LeavesTheNoiseAlone) {
  const MarkerMap map = WideMarkers();
  const Pose truth = LookingAtTheWall(7.0, 0.0);
  constexpr int kNumFrames = 1500;
  std::vector<Detection> detections;
  std::vector<AdjustedFrame> frames;
  for (int i = 0; i < kNumFrames; ++i) {
    AdjustedFrame frame = {truth, {}};
    for (const Detection& one : ObserveCorners(SyntheticCamera(), map, truth, 0.1 * i)) {
      frame.detections.push_back(static_cast<int>(detections.size()));
      detections.push_back(one);
    }
    frames.push_back(frame);
  }
  std::mt19937 random(3);
  AddNoise(0.3, &random, &detections);
  const auto found =
      AdjustBundle(SyntheticCamera(), map, {}, detections, frames, {.corner_sigma = 0.3});
  ASSERT_TRUE(found.is_usable) << found.message;
  std::vector<StampedPose> track;
  for (int i = 0; i < kNumFrames; ++i) track.push_back({0.1 * i, found.world_from_camera[i], {}});
  const auto mean_and_std = [&] {
    double sum = 0.0, squares = 0.0;
    for (const StampedPose& one : track) {
      const double error = one.pose.translation.x() - truth.translation.x();
      sum += error, squares += error * error;
    }
    const double mean = sum / kNumFrames;
    return std::pair(mean, std::sqrt(squares / kNumFrames - mean * mean));
  };
  const auto [mean_before, std_before] = mean_and_std();
  const std::vector<std::vector<int>> ids(kNumFrames, IdsOf(map));
  RemoveBias(SyntheticCamera(), map, ids, found.corner_sigma, &track);
  const auto [mean_after, std_after] = mean_and_std();
  const double std_of_mean = std_before / std::sqrt(kNumFrames);
  EXPECT_GT(mean_before, 15.0 * std_of_mean);
  EXPECT_LT(std::abs(mean_after), 4.0 * std_of_mean + 0.1 * mean_before);
  EXPECT_NEAR(std_after, std_before, 0.02 * std_before);
}

}  // namespace
}  // namespace fathom
