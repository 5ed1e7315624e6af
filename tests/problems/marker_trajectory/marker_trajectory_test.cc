// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/marker_trajectory.h"

#include "fathom/base/input_error.h"

#include <random>

#include "synthetic_views.h"
#include <Eigen/Cholesky>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Ahead of the body and below it, looking ahead: z along the body's x, x along its y.

double Square(const Pose& found, const Pose& truth, const PoseCovariance& covariance) {
  const PoseIncrement error = StepBetween(found, truth);
  return error.dot(covariance.ldlt().solve(error));
}

// Every coordinate against the Cramer-Rao bound: the spread of 300 errors, each over its own
// standard deviation. It is known to 1 / sqrt(600); the lens' curvature is not felt.
TEST(TrackMarkers, ReachesTheCramerRaoBoundWithOneMarker) {
  const MarkerMap map = SingleMarker();
  const SyntheticRecord record = MakeRecord(map, 300, 0.5, kCornerSigma, 21);
  const MarkerTrack track =
      TrackMarkers(record.detections, SyntheticCamera(), map, kBodyFromCamera);
  ASSERT_TRUE(track.IsUsable()) << track.message;
  ASSERT_EQ(track.world_from_camera.size(), 300u);
  for (int k = 0; k < 6; ++k) {
    double of_camera = 0.0, of_body = 0.0;
    for (int i = 0; i < 300; ++i) {
      const Pose truth = record.world_from_camera[i];
      const StampedPose& camera = track.world_from_camera[i];
      const StampedPose& body = track.world_from_body[i];
      EXPECT_EQ(camera.time, record.time[i]);
      of_camera += std::pow(StepBetween(camera.pose, truth)[k], 2) / camera.covariance(k, k);
      of_body += std::pow(StepBetween(body.pose, truth * kBodyFromCamera.Inverse())[k], 2) /
                 body.covariance(k, k);
    }
    EXPECT_NEAR(std::sqrt(of_camera / 300), 1.0, 5.0 / std::sqrt(600.0)) << k;
    EXPECT_NEAR(std::sqrt(of_body / 300), 1.0, 5.0 / std::sqrt(600.0)) << k;
  }
  EXPECT_LT(std::abs(track.corner_sigma - kCornerSigma), 4.0 * track.corner_sigma_std);
  EXPECT_THAT(track.estimated_ids, IsEmpty());
}

// As many coordinates of the 20 fast frames of four records: their stated spread is known to
// 1 / sqrt(2 * 80), and so is that of the others, of whom there are more.
TEST(TrackMarkers, StatesTheErrorsOfNoisyFrames) {
  const MarkerMap map = WallOfMarkers(10, 5, 0.22, 0.15);
  for (const bool is_fast : {true, false}) {
    PoseIncrement squares = PoseIncrement::Zero();
    int num = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const SyntheticRecord record = MakeWallRecord(map, 100, 1.5, 0.44, seed);
      const MarkerTrack track = TrackMarkers(record.detections, WallCamera(), map, kBodyFromCamera);
      ASSERT_EQ(track.world_from_camera.size(), 100u);
      for (int i = 0; i < 100; ++i) {
        if ((i % 5 == 2) != is_fast) continue;
        const StampedPose& found = track.world_from_camera[i];
        const PoseIncrement error = StepBetween(found.pose, record.world_from_camera[i]);
        squares += error.cwiseAbs2().cwiseQuotient(found.covariance.diagonal());
        ++num;
      }
    }
    for (int k = 0; k < 6; ++k) {
      EXPECT_NEAR(std::sqrt(squares[k] / num), 1.0, 4.0 / std::sqrt(2.0 * 80.0)) << k;
    }
  }
}

// Forty-eight markers along a wall, of which the first six are surveyed, and the camera goes along.
TEST(TrackMarkers, PlacesManyMarkersAlongAWall) {
  const MarkerMap truth = WallOfMarkers(48, 24, 0.2, 0.12);
  MarkerMap map = truth;
  for (Marker& marker : map.markers) {
    if (marker.id % 24 < 3) continue;
    marker.is_surveyed = false;
    marker.world_from_tag = Pose();
  }
  std::mt19937 random(2);
  SyntheticRecord record;
  for (int i = 0; i < 80; ++i) {
    const double t = 0.2 * i;
    const double sigma = i % 3 == 0 ? 0.3 : 0.2;
    AddWallFrame(truth, t, WallPoseAt(t, 1.3, -2.2 + 0.055 * i), sigma, &random, &record);
  }
  const MarkerTrack track = TrackMarkers(record.detections, WallCamera(), map, kBodyFromCamera);
  ASSERT_TRUE(track.IsUsable()) << track.message;
  EXPECT_EQ(track.world_from_camera.size(), 80u);
  ASSERT_EQ(track.estimated_ids.size(), 42u);
  for (std::size_t k = 0; k < track.estimated_ids.size(); ++k) {
    const int id = track.estimated_ids[k];
    // One of 42 chi-squares of 6 degrees of freedom is above 33 once in 2000 times.
    EXPECT_LT(Square(track.map.Find(id)->world_from_tag,
                     truth.Find(id)->world_from_tag,
                     track.marker_covariance[k]),
              33.0)
        << id;
  }
}

// Tag 0 is surveyed. Tag 1 is seen with it, tag 2 with 1 only, tag 3 with 2 only.
TEST(TrackMarkers, PlacesMarkersOutwardsFromTheSurveyedOne) {
  MarkerMap map = FourMarkers();
  const MarkerMap truth = map;
  SyntheticRecord record = MakeRecord(map, 120, 0.3, kCornerSigma, 22);
  for (int id = 1; id < 4; ++id) {
    map.markers[id].is_surveyed = false;
    map.markers[id].world_from_tag = Pose();
  }
  std::erase_if(record.detections, [&](const Detection& detection) {
    const int third = static_cast<int>((detection.time - 100.0) / 4.0);
    return detection.tag_id != third && detection.tag_id != third + 1;
  });
  const MarkerTrack track =
      TrackMarkers(record.detections, SyntheticCamera(), map, kBodyFromCamera);
  ASSERT_TRUE(track.IsUsable()) << track.message;
  EXPECT_EQ(track.world_from_camera.size(), 120u - track.pnp.times_without_pose.size());
  EXPECT_LE(track.pnp.times_without_pose.size(), 1u)
      << "the first at " << track.pnp.times_without_pose.front();
  EXPECT_THAT(track.estimated_ids, ElementsAre(1, 2, 3));
  for (int k = 0; k < 3; ++k) {
    const int id = track.estimated_ids[k];
    // 99.99 % of a chi-square of 6 degrees of freedom is below 27.9.
    EXPECT_LT(Square(track.map.Find(id)->world_from_tag,
                     truth.Find(id)->world_from_tag,
                     track.marker_covariance[k]),
              27.9)
        << id;
  }
  // Further out, less is known.
  EXPECT_GT(track.marker_covariance[2].trace(), track.marker_covariance[0].trace());
}

TEST(TrackMarkers, SaysWhichMarkersItCouldNotPlace) {
  MarkerMap map = FourMarkers();
  SyntheticRecord record = MakeRecord(map, 40, 0.3, kCornerSigma, 23);
  map.markers[3].is_surveyed = false;
  std::erase_if(record.detections, [&](const Detection& detection) {
    return (detection.tag_id == 3) != (detection.time > 102.0);
  });
  const MarkerTrack track =
      TrackMarkers(record.detections, SyntheticCamera(), map, kBodyFromCamera);
  ASSERT_TRUE(track.IsUsable()) << track.message;
  EXPECT_THAT(track.unplaced_ids, ElementsAre(3));
  EXPECT_THAT(TextsOf(track.remarks), Contains(HasSubstr("never seen together")));
  EXPECT_THAT(TextsOf(track.remarks), Contains(HasSubstr("Set aside as not surveyed: ")));
}

// A marker that hangs elsewhere in every frame has no place: what was tried for it is not written
// as if it were one.
TEST(TrackMarkers, TakesBackAPlaceThatNoFrameAgreesWith) {
  MarkerMap map = FourMarkers();
  SyntheticRecord record = MakeRecord(map, 40, 0.3, kCornerSigma, 23);
  map.markers[2].is_surveyed = false;
  map.markers[3].is_surveyed = false;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> shift(-150.0, 150.0);
  for (Detection& detection : record.detections) {
    if (detection.tag_id != 3) continue;
    const Eigen::Vector2d by(shift(generator), shift(generator));
    for (Eigen::Vector2d& corner : detection.corners) corner += by;
  }
  const MarkerTrack track =
      TrackMarkers(record.detections, SyntheticCamera(), map, kBodyFromCamera);
  ASSERT_TRUE(track.IsUsable()) << track.message;
  EXPECT_THAT(track.estimated_ids, Contains(2));
  EXPECT_THAT(track.refuted_ids, ElementsAre(3));
  EXPECT_FALSE(track.map.Find(3)->is_surveyed);
  EXPECT_THAT(TextsOf(track.remarks),
              Contains(HasSubstr("Not used, because no position agrees with the frames that show "
                                 "them: tags 3. Did they move?")));
}

// A survey that is wrong by centimetres and a degree: with one marker as the reference the others
// come out within their intervals, and the residuals fall to the noise.
TEST(TrackMarkers, CorrectsASurveyFromAReference) {
  const MarkerMap truth = FourMarkers();
  const SyntheticRecord record = MakeRecord(truth, 150, 0.3, kCornerSigma, 24);
  MarkerMap survey = truth;
  PoseIncrement wrong;
  wrong << 0.02, -0.03, 0.01, 0.02, -0.01, 0.015;
  survey.markers[0].world_from_tag = Moved(survey.markers[0].world_from_tag, wrong);
  survey.markers[3].world_from_tag = Moved(survey.markers[3].world_from_tag, -wrong);
  const auto as_surveyed =
      TrackMarkers(record.detections, SyntheticCamera(), survey, kBodyFromCamera);
  ASSERT_TRUE(as_surveyed.IsUsable());
  EXPECT_GT(as_surveyed.corner_sigma, 5.0 * kCornerSigma);
  MarkerTrajectoryOptions options;
  options.estimate_surveyed_markers = true;
  options.reference_id = 2;
  const auto track =
      TrackMarkers(record.detections, SyntheticCamera(), survey, kBodyFromCamera, options);
  ASSERT_TRUE(track.IsUsable()) << track.message;
  EXPECT_LT(std::abs(track.corner_sigma - kCornerSigma), 4.0 * track.corner_sigma_std);
  ASSERT_THAT(track.estimated_ids, ElementsAre(0, 1, 3));
  for (int k = 0; k < 3; ++k) {
    const int id = track.estimated_ids[k];
    EXPECT_LT(Square(track.map.Find(id)->world_from_tag,
                     truth.Find(id)->world_from_tag,
                     track.marker_covariance[k]),
              27.9);
  }
  options.reference_id = 17;
  EXPECT_THROW(TrackMarkers(record.detections, SyntheticCamera(), survey, kBodyFromCamera, options),
               InputError);
}

TEST(TrackMarkers, IsNotUsableWithoutAnyKnownTag) {
  MarkerMap map = SingleMarker();
  const SyntheticRecord record = MakeRecord(map, 20, 0.2, kCornerSigma, 25);
  map.markers[0].id = 5;
  const MarkerTrack track =
      TrackMarkers(record.detections, SyntheticCamera(), map, kBodyFromCamera);
  EXPECT_FALSE(track.IsUsable());
  EXPECT_EQ(track.message, "there is no frame with a pose.");
  EXPECT_THAT(TextsOf(track.remarks),
              Contains("Set aside as unknown id: 20 of 20 detections: tags 0 (20 times)."));
}

}  // namespace
}  // namespace fathom
