// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/bundle/bundle_adjustment.h"

#include "synthetic_views.h"
#include <Eigen/Cholesky>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Start {
  MarkerMap map;
  std::vector<AdjustedFrame> frames;
};

// Poses and free markers that are off by a few centimetres and degrees.
Start StartNear(const SyntheticRecord& record,
                const MarkerMap& map,
                const std::set<int>& free_ids) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.0, 0.02);
  const auto nudged = [&](const Pose& pose) {
    PoseIncrement step;
    for (double& number : step) number = normal(random);
    return Moved(pose, step);
  };
  Start start = {.map = map, .frames = {}};
  for (Marker& marker : start.map.markers) {
    if (free_ids.contains(marker.id)) marker.world_from_tag = nudged(marker.world_from_tag);
  }
  int next = 0;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    AdjustedFrame frame = {.world_from_camera = nudged(record.world_from_camera[i]),
                           .detections = {}};
    while (next < static_cast<int>(record.detections.size()) &&
           record.detections[next].time == record.time[i]) {
      frame.detections.push_back(next++);
    }
    start.frames.push_back(frame);
  }
  return start;
}

double NormalisedSquare(const Pose& found, const Pose& truth, const PoseCovariance& covariance) {
  const PoseIncrement error = StepBetween(found, truth);
  return error.dot(covariance.ldlt().solve(error));
}

TEST(BundleAdjustment, RecoversTheTruthFromPerfectCorners) {
  const MarkerMap map = FourMarkers();
  const std::set<int> free_ids = {1, 3};
  const SyntheticRecord record = MakeRecord(map, 20, 0.3, 0.0, 1);
  const Start start = StartNear(record, map, free_ids);
  const auto summary =
      AdjustBundle(SyntheticCamera(), start.map, free_ids, record.detections, start.frames);
  ASSERT_TRUE(summary.is_usable) << summary.message;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    EXPECT_LT(StepBetween(summary.world_from_camera[i], record.world_from_camera[i]).norm(), 1e-8);
    EXPECT_LT(summary.frame_rms[i], 1e-6);
  }
  for (const int id : free_ids) {
    EXPECT_LT(
        StepBetween(summary.map.Find(id)->world_from_tag, map.Find(id)->world_from_tag).norm(),
        1e-8);
  }
}

// Errors over repeated runs in units of the reported covariance: chi-squares of 6 degrees of
// freedom, mean 6 and variance 12. Poses of one run share the error of the free markers; with 20
// frames of 40 runs counted as 40 independent ones the bound is on the safe side.
TEST(BundleAdjustment, CovarianceMatchesTheSpreadOverRepeatedRuns) {
  constexpr int kNumRuns = 40;
  struct Case {
    MarkerMap map;
    std::set<int> free_ids;
  };
  for (const Case& one : {Case{SingleMarker(), {}}, Case{FourMarkers(), {0, 1, 3}}}) {
    double poses = 0.0, markers = 0.0, sigma = 0.0;
    for (int seed = 0; seed < kNumRuns; ++seed) {
      const SyntheticRecord record = MakeRecord(one.map, 20, 0.5, kCornerSigma, 10 + seed);
      const Start start = StartNear(record, one.map, one.free_ids);
      const auto summary = AdjustBundle(
          SyntheticCamera(),
          start.map,
          one.free_ids,
          record.detections,
          start.frames,
          {.corner_sigma = kCornerSigma, .huber = std::numeric_limits<double>::infinity()});
      ASSERT_TRUE(summary.is_usable) << summary.message;
      // The covariances of the true sigma: how well one run knows it is another matter.
      const double rescale = std::pow(kCornerSigma / summary.corner_sigma, 2);
      for (std::size_t i = 0; i < record.time.size(); ++i) {
        poses += NormalisedSquare(summary.world_from_camera[i],
                                  record.world_from_camera[i],
                                  rescale * summary.pose_covariance[i]) /
                 static_cast<double>(record.time.size());
      }
      ASSERT_EQ(summary.marker_covariance.size(), one.free_ids.size());
      for (std::size_t k = 0; k < summary.free_ids.size(); ++k) {
        const int id = summary.free_ids[k];
        markers += NormalisedSquare(summary.map.Find(id)->world_from_tag,
                                    one.map.Find(id)->world_from_tag,
                                    rescale * summary.marker_covariance[k]) /
                   static_cast<double>(one.free_ids.size());
      }
      sigma += (summary.corner_sigma - kCornerSigma) / summary.corner_sigma_std;
    }
    const double bound = 4.0 * std::sqrt(12.0 / kNumRuns);
    EXPECT_NEAR(poses / kNumRuns, 6.0, bound);
    if (!one.free_ids.empty()) {
      EXPECT_NEAR(markers / kNumRuns, 6.0, bound);
    }
    EXPECT_NEAR(sigma / kNumRuns, 0.0, 4.0 / std::sqrt(kNumRuns));
  }
}

// The covariance of a pose against one computed anew: finite differences of the projection alone.
TEST(BundleAdjustment, CovarianceIsTheInverseInformationOfFiniteDifferences) {
  const MarkerMap map = SingleMarker();
  const SyntheticRecord record = MakeRecord(map, 5, 0.5, kCornerSigma, 3);
  const Start start = StartNear(record, map, {});
  const auto summary = AdjustBundle(SyntheticCamera(),
                                    start.map,
                                    {},
                                    record.detections,
                                    start.frames,
                                    {.corner_sigma = kCornerSigma, .huber = 1e9});
  ASSERT_TRUE(summary.is_usable) << summary.message;
  constexpr double kStep = 1e-6;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    Eigen::Matrix<double, 8, 6> jacobian;
    for (int k = 0; k < 6; ++k) {
      const PoseIncrement step = kStep * PoseIncrement::Unit(k);
      const auto up =
          ObserveCorners(SyntheticCamera(), map, Moved(summary.world_from_camera[i], step));
      const auto down =
          ObserveCorners(SyntheticCamera(), map, Moved(summary.world_from_camera[i], -step));
      for (int c = 0; c < 4; ++c) {
        jacobian.block<2, 1>(2 * c, k) = (up[0].corners[c] - down[0].corners[c]) / (2.0 * kStep);
      }
    }
    const PoseCovariance expected =
        std::pow(summary.corner_sigma, 2) * (jacobian.transpose() * jacobian).inverse().eval();
    for (int k = 0; k < 6; ++k) {
      EXPECT_NEAR(
          std::sqrt(summary.pose_covariance[i](k, k)) / std::sqrt(expected(k, k)), 1.0, 1e-4);
    }
  }
}

TEST(BundleAdjustment, SaysWhenAFreeMarkerHangsOnNothing) {
  const MarkerMap map = FourMarkers();
  const SyntheticRecord record = MakeRecord(map, 20, 0.3, kCornerSigma, 1);
  // Tag 3 in frames of its own.
  Start start = StartNear(record, map, {3});
  for (std::size_t i = 0; i < start.frames.size(); ++i) {
    std::erase_if(start.frames[i].detections, [&](int index) {
      return (record.detections[index].tag_id == 3) != (i % 2 == 0);
    });
  }
  const auto summary = AdjustBundle(SyntheticCamera(),
                                    start.map,
                                    {3},
                                    record.detections,
                                    start.frames,
                                    {.corner_sigma = kCornerSigma});
  EXPECT_FALSE(summary.is_usable);
  EXPECT_THAT(summary.message, HasSubstr("never seen together"));
}

TEST(BundleAdjustment, ToleratesBadCorners) {
  const MarkerMap map = FourMarkers();
  SyntheticRecord record = MakeRecord(map, 40, 0.3, kCornerSigma, 4);
  std::mt19937 random(5);
  std::uniform_int_distribution<std::size_t> any(0, record.detections.size() - 1);
  for (int i = 0; i < 3; ++i) record.detections[any(random)].corners[i] += Eigen::Vector2d(9, -12);
  const Start start = StartNear(record, map, {1});
  const auto worst = [&](double huber) {
    const auto summary = AdjustBundle(SyntheticCamera(),
                                      start.map,
                                      {1},
                                      record.detections,
                                      start.frames,
                                      {.corner_sigma = kCornerSigma, .huber = huber});
    EXPECT_TRUE(summary.is_usable) << summary.message;
    double worst_of_all = 0.0;
    for (std::size_t i = 0; i < record.time.size(); ++i) {
      worst_of_all =
          std::max(worst_of_all,
                   StepBetween(summary.world_from_camera[i], record.world_from_camera[i]).norm());
    }
    return worst_of_all;
  };
  EXPECT_LT(worst(3.0), 0.5 * worst(std::numeric_limits<double>::infinity()));
}

}  // namespace
}  // namespace fathom
