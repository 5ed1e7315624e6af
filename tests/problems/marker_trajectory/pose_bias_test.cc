// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/pose_bias.h"

#include "fathom/marker_trajectory/bundle/bundle_adjustment.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "synthetic_views.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Gt;
using ::testing::Lt;

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
  return scatter;
}

// Every coordinate, within four of the mean's standard deviations and a fifth of the bias itself:
// what is left is of fourth order in the noise.
TEST(BiasOfPose, IsTheMeanErrorOfManyFits) {
  struct Case {
    MarkerMap map;
    double distance, tilt, sigma;
    bool is_clear;  // the mean error is many of its standard deviations
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
    if (one.is_clear) {
      EXPECT_GT(scatter.mean[0], 10.0 * scatter.std_of_mean[0]);
    }
  }
}

// docs/marker_trajectory.md (3): 3/4 d s^2 towards a single marker seen face on.
TEST(BiasOfPose, IsTheClosedFormFaceOn) {
  constexpr double kDistance = 3.0, kSigma = 0.03;
  const Pose truth = LookingAtTheWall(kDistance, 0.0);
  std::vector<Detection> corners = ObserveCorners(SyntheticCamera(), SingleMarker(), truth, 0.0);
  std::mt19937 random(17);
  AddNoise(1e-6, &random, &corners);
  const std::vector<AdjustedFrame> frames = {{truth, {0}}};
  const auto fit = AdjustBundle(
      SyntheticCamera(), SingleMarker(), {}, corners, frames, {.corner_sigma = kSigma});
  ASSERT_TRUE(fit.is_usable) << fit.message;
  const PoseCovariance covariance =
      fit.pose_covariance.front() * std::pow(kSigma / fit.corner_sigma, 2);
  const PoseIncrement bias =
      BiasOfPose(SyntheticCamera(), SingleMarker(), std::vector<int>{0}, truth, kSigma);
  const double closed_form = 0.75 * kDistance * (covariance(3, 3) + covariance(4, 4));
  EXPECT_NEAR(bias[0], closed_form, 0.05 * closed_form);
}

// Other axes of the world turn what is along them, and leave what is about the camera's.
TEST(BiasOfPose, TurnsWithTheWorld) {
  const Pose turn = {Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized(), {4.0, -2.0, 1.0}};
  MarkerMap turned = WideMarkers();
  for (Marker& marker : turned.markers) marker.world_from_tag = turn * marker.world_from_tag;
  const Pose pose = LookingAtTheWall(6.0, 0.3);
  const std::vector<int> ids = IdsOf(turned);
  const PoseIncrement here = BiasOfPose(SyntheticCamera(), WideMarkers(), ids, pose, 0.5);
  const PoseIncrement there = BiasOfPose(SyntheticCamera(), turned, ids, turn * pose, 0.5);
  EXPECT_GT(here.head<3>().norm(), 1e-3);
  EXPECT_GT(here.tail<3>().norm(), 1e-6);
  EXPECT_LT((there.head<3>() - turn.rotation * here.head<3>()).norm(), 1e-5 * here.norm());
  EXPECT_LT((there.tail<3>() - here.tail<3>()).norm(), 1e-5 * here.norm());
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

// Ever further off it grows, and does not jump.
TEST(BiasOfPose, GrowsSteadilyWithTheDistance) {
  double before = 0.0;
  for (double distance = 4.0; distance < 40.0; distance *= 1.05) {
    const double bias = BiasOfPose(SyntheticCamera(),
                                   SingleMarker(),
                                   std::vector<int>{0},
                                   LookingAtTheWall(distance, 0.0),
                                   0.3)[0];
    if (before > 0.0) {
      EXPECT_THAT(bias / before, AllOf(Gt(1.0), Lt(1.3))) << distance;
    }
    before = bias;
  }
}

TEST(BiasOfPose, IsNothingWithoutNoiseOrCorners) {
  const Pose truth = LookingAtTheWall(3.0, 0.0);
  const std::vector<int> ids = {0};
  EXPECT_EQ(BiasOfPose(SyntheticCamera(), SingleMarker(), ids, truth, 0.0).norm(), 0.0);
  EXPECT_EQ(BiasOfPose(SyntheticCamera(), SingleMarker(), {}, truth, 0.3).norm(), 0.0);
}

// The fits of a record, frame by frame.
struct Fits {
  std::vector<StampedPose> track;
  std::vector<std::vector<int>> tag_ids;
  std::vector<Pose> truth;
};

// `truth_at` gives the camera's pose at a time, `sees` whether a tag is seen in a frame.
template <typename TruthAt, typename Sees>
Fits FitFrames(const MarkerMap& map, int num_frames, TruthAt truth_at, Sees sees) {
  constexpr double kSigma = 0.3;
  Fits fits;
  std::vector<Detection> detections;
  std::vector<AdjustedFrame> frames;
  for (int i = 0; i < num_frames; ++i) {
    const double t = 0.1 * i;
    fits.truth.push_back(truth_at(t));
    frames.push_back({fits.truth.back(), {}});
    fits.tag_ids.emplace_back();
    for (const Detection& one : ObserveCorners(SyntheticCamera(), map, fits.truth.back(), t)) {
      if (!sees(i, one.tag_id)) continue;
      frames.back().detections.push_back(static_cast<int>(detections.size()));
      fits.tag_ids.back().push_back(one.tag_id);
      detections.push_back(one);
    }
  }
  std::mt19937 random(3);
  AddNoise(kSigma, &random, &detections);
  const auto found =
      AdjustBundle(SyntheticCamera(), map, {}, detections, frames, {.corner_sigma = kSigma});
  EXPECT_TRUE(found.is_usable) << found.message;
  for (int i = 0; i < num_frames; ++i) {
    fits.track.push_back({0.1 * i, found.world_from_camera[i], found.pose_covariance[i]});
  }
  return fits;
}

// Mean and standard deviation of the errors towards the wall.
std::pair<double, double> ErrorsOf(const Fits& fits, std::size_t from, std::size_t to) {
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = from; i < to; ++i) {
    const double error = fits.track[i].pose.translation.x() - fits.truth[i].translation.x();
    sum += error, squares += error * error;
  }
  const double mean = sum / (to - from);
  return {mean, std::sqrt(squares / (to - from) - mean * mean)};
}

// The noise of the poses is as it was, their mean is not.
TEST(RemoveBias, LeavesTheNoiseAlone) {
  constexpr int kNumFrames = 1500;
  const auto stands = [](double) { return LookingAtTheWall(7.0, 0.0); };
  Fits fits = FitFrames(WideMarkers(), kNumFrames, stands, [](int, int) { return true; });
  const auto [mean_before, std_before] = ErrorsOf(fits, 0, kNumFrames);
  RemoveBias(SyntheticCamera(), WideMarkers(), fits.tag_ids, 0.3, &fits.track);
  const auto [mean_after, std_after] = ErrorsOf(fits, 0, kNumFrames);
  const double std_of_mean = std_before / std::sqrt(kNumFrames);
  EXPECT_GT(mean_before, 15.0 * std_of_mean);
  EXPECT_LT(std::abs(mean_after), 4.0 * std_of_mean + 0.1 * mean_before);
  EXPECT_NEAR(std_after, std_before, 0.02 * std_before);
}

// A camera that goes to and fro between 2 and 7 m at up to 1 m/s, sees all four markers in one
// frame and the two on the left in the next, and nothing for a second out of ten.
TEST(RemoveBias, FollowsAMotionWithMarkersThatComeAndGo) {
  const auto swings = [](double t) {
    return LookingAtTheWall(4.5 + 2.5 * std::sin(0.4 * t), 0.03 * std::sin(0.3 * t));
  };
  const auto sees = [](int frame, int id) { return frame % 2 == 0 || id < 2; };
  Fits fits = FitFrames(WideMarkers(), 3000, swings, sees);
  for (std::size_t i = fits.track.size(); i-- > 0;) {
    if (i % 100 < 90) continue;
    fits.track.erase(fits.track.begin() + i);
    fits.tag_ids.erase(fits.tag_ids.begin() + i);
    fits.truth.erase(fits.truth.begin() + i);
  }
  const auto [mean_before, std_before] = ErrorsOf(fits, 0, fits.track.size());
  RemoveBias(SyntheticCamera(), WideMarkers(), fits.tag_ids, 0.3, &fits.track);
  const auto [mean_after, std_after] = ErrorsOf(fits, 0, fits.track.size());
  const double std_of_mean = std_before / std::sqrt(fits.track.size());
  EXPECT_GT(mean_before, 10.0 * std_of_mean);
  EXPECT_LT(std::abs(mean_after), 4.0 * std_of_mean);
  EXPECT_LT(std_after, 1.01 * std_before);
}

// A flip that is not resolved lends its neighbours nothing of its attitude.
TEST(RemoveBias, LeavesOutNeighboursThatAreFlipped) {
  const auto stands = [](double) { return LookingAtTheWall(4.0, 0.3); };
  Fits fits = FitFrames(SingleMarker(), 60, stands, [](int, int) { return true; });
  Fits flipped = fits;
  for (std::size_t i = 0; i < fits.track.size(); i += 3) {
    Pose& pose = flipped.track[i].pose;
    pose = LookingAtTheWall(4.0, -0.3);
  }
  RemoveBias(SyntheticCamera(), SingleMarker(), fits.tag_ids, 0.3, &fits.track);
  const std::vector<StampedPose> as_found = flipped.track;
  RemoveBias(SyntheticCamera(), SingleMarker(), flipped.tag_ids, 0.3, &flipped.track);
  for (std::size_t i = 0; i < fits.track.size(); ++i) {
    if (i % 3 == 0) continue;
    const double taken = (as_found[i].pose.translation - flipped.track[i].pose.translation).norm();
    const double right = (as_found[i].pose.translation - fits.track[i].pose.translation).norm();
    EXPECT_NEAR(taken, right, 0.3 * right) << i;
  }
}

}  // namespace
}  // namespace fathom
