// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/pose_track.h"

#include <set>

#include "error_from.h"
#include "synthetic_views.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

int NumRejected(const PoseTrack& track, Rejection reason) {
  return static_cast<int>(std::count_if(
      track.rejected.begin(), track.rejected.end(), [&](const RejectedDetection& one) {
        return one.reason == reason;
      }));
}

// Every frame and every detection is accounted for, once.
void ExpectNothingIsLost(const PoseTrack& track) {
  EXPECT_EQ(track.num_frames,
            static_cast<int>(track.views.size() + track.times_without_pose.size()) +
                track.num_frames_without_tags);
  std::multiset<int> seen;
  for (const RejectedDetection& one : track.rejected) seen.insert(one.index);
  for (const TrackedView& view : track.views) {
    EXPECT_EQ(view.detections.size(), view.pose.used.size());
    seen.insert(view.detections.begin(), view.detections.end());
  }
  ASSERT_EQ(seen.size(), static_cast<std::size_t>(track.num_detections));
  int next = 0;
  for (const int index : seen) EXPECT_EQ(index, next++);
}

double WorstTurn(const PoseTrack& track, const SyntheticRecord& record) {
  double worst = 0.0;
  std::size_t i = 0;
  for (const TrackedView& view : track.views) {
    while (record.time[i] < view.time) ++i;
    worst = std::max(
        worst,
        StepBetween(view.pose.world_from_camera, record.world_from_camera[i]).tail<3>().norm());
  }
  return worst;
}

// A marker of some 50 px, tilted by 14 degrees, corners to 0.4 px: single frames often prefer the
// wrong one of two solutions, the record almost never. Which of a frame's solutions is the right
// one is decided by the truth.
TEST(TrackPoses, ResolvesTheFlipOfASingleSquare) {
  MarkerMap map = SingleMarker();
  map.markers[0].size = 0.25;
  const SyntheticRecord record = MakeRecord(map, 400, 0.25, 0.4, 5);
  ASSERT_EQ(record.detections.size(), 400u);
  const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
  ExpectNothingIsLost(track);
  ASSERT_GE(track.views.size(), 395u);
  int wrong_in_a_frame = 0, wrong_in_the_track = 0, num_resolved = 0;
  for (const TrackedView& view : track.views) {
    const int i = view.detections[0];
    const Pose& truth = record.world_from_camera[i];
    const auto turn_from_truth = [&](const ViewPose& pose) {
      return StepBetween(pose.world_from_camera, truth).tail<3>().norm();
    };
    const auto poses = SolveView(SyntheticCamera(), map, {&record.detections[i], 1});
    if (poses.size() < 2) continue;
    const double best = std::min(turn_from_truth(poses[0]), turn_from_truth(poses[1]));
    wrong_in_a_frame += turn_from_truth(poses[0]) > best + 0.05;
    wrong_in_the_track += turn_from_truth(view.pose) > best + 0.05;
    num_resolved += view.is_flip_resolved;
  }
  EXPECT_GT(wrong_in_a_frame, 20);
  EXPECT_LE(wrong_in_the_track, 4);
  EXPECT_GE(num_resolved, wrong_in_a_frame - 4);
}

// 30 independent records, one marker each with two degrees of freedom per frame: the reported
// standard deviation is that of the estimate.
TEST(TrackPoses, EstimatesTheCornerSigmaWithItsError) {
  for (const MarkerMap& map : {SingleMarker(), FourMarkers()}) {
    constexpr int kNumRuns = 30;
    double sum = 0.0, sum_of_squares = 0.0;
    for (int seed = 0; seed < kNumRuns; ++seed) {
      const SyntheticRecord record = MakeRecord(map, 50, 0.6, 0.3, 100 + seed);
      const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
      const double z = (track.corner_sigma - 0.3) / track.corner_sigma_std;
      sum += z;
      sum_of_squares += z * z;
    }
    EXPECT_NEAR(sum / kNumRuns, 0.0, 4.0 / std::sqrt(kNumRuns));
    EXPECT_NEAR(sum_of_squares / kNumRuns, 1.0, 4.0 * std::sqrt(2.0 / kNumRuns));
  }
}

// Seen face on from afar, the tilt of a single marker takes up noise that counts as two degrees of
// freedom: docs/vision.md (8) says by how much the corner sigma is then too small. Not so where the
// tilt is known from the perspective, or the marker is seen at an angle, or by several markers.
TEST(TrackPoses, UnderstatesTheCornerSigmaOfOneMarkerSeenFaceOnAsDocumented) {
  const auto found = [](const MarkerMap& map, double distance, double tilt, int num) {
    std::mt19937 random(17);
    std::vector<Detection> detections;
    for (int i = 0; i < num; ++i) {
      Pose pose = OnTheWall(0.1, 0.1);
      pose.translation.x() = 3.0 - distance * std::cos(tilt);
      pose.translation.y() -= distance * std::sin(tilt);
      pose.rotation = pose.rotation * Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY());
      for (const Detection& one : ObserveCorners(SyntheticCamera(), map, pose, 0.1 * i)) {
        detections.push_back(one);
      }
    }
    AddNoise(0.3, &random, &detections);
    const PoseTrack track = TrackPoses(detections, SyntheticCamera(), map);
    EXPECT_EQ(static_cast<int>(track.views.size()), num);
    return track.corner_sigma / 0.3;
  };
  // 1500 frames of two degrees of freedom: 1.3 % of standard deviation; four of them.
  constexpr double kFourSigma = 4.0 * 0.013;
  EXPECT_NEAR(found(SingleMarker(), 2.0, 0.0, 1500), 0.99, kFourSigma);
  EXPECT_NEAR(found(SingleMarker(), 3.0, 0.0, 1500), 0.92, kFourSigma);
  EXPECT_NEAR(found(SingleMarker(), 4.5, 0.0, 1500), 0.78, kFourSigma);
  EXPECT_NEAR(found(SingleMarker(), 3.0, 0.25, 1500), 0.99, kFourSigma);
  EXPECT_NEAR(found(FourMarkers(), 3.0, 0.0, 115), 1.0, kFourSigma);  // 26 degrees each
}

TEST(TrackPoses, SetsAsideOutliersOfASingleMarker) {
  const MarkerMap map = SingleMarker();
  SyntheticRecord record = MakeRecord(map, 300, 0.4, 0.3, 8);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> far(-60.0, 60.0);
  std::set<int> spoiled;
  for (const int i : {3, 57, 58, 120, 199, 298}) {
    spoiled.insert(i);
    for (Eigen::Vector2d& corner : record.detections[i].corners) {
      corner += Eigen::Vector2d(far(random), far(random));
    }
  }
  const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
  ExpectNothingIsLost(track);
  std::set<int> rejected;
  for (const RejectedDetection& one : track.rejected) rejected.insert(one.index);
  for (const int i : spoiled) EXPECT_THAT(rejected, Contains(i));
  EXPECT_LE(rejected.size(), spoiled.size() + 2);
  EXPECT_LT(std::abs(track.corner_sigma - 0.3), 5.0 * track.corner_sigma_std);
}

// A whole detection shifted: its shape is right, and only the frames around it contradict it.
TEST(TrackPoses, SetsAsideAJumpAwayAndBack) {
  const MarkerMap map = SingleMarker();
  SyntheticRecord record = MakeRecord(map, 200, 0.4, 0.3, 9);
  for (Eigen::Vector2d& corner : record.detections[77].corners) corner.x() -= 200.0;
  const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
  ExpectNothingIsLost(track);
  ASSERT_EQ(NumRejected(track, Rejection::kOutlier), 1);
  EXPECT_EQ(track.rejected[0].index, 77);
  EXPECT_THAT(track.times_without_pose, ::testing::ElementsAre(record.time[77]));
}

TEST(TrackPoses, GoesOnAfterALongRunOfOutliers) {
  const MarkerMap map = SingleMarker();
  SyntheticRecord record = MakeRecord(map, 200, 0.4, 0.3, 10);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> far(-40.0, 40.0);
  for (int i = 100; i < 120; ++i) {
    for (Eigen::Vector2d& corner : record.detections[i].corners) {
      corner += Eigen::Vector2d(far(random), far(random));
    }
  }
  const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
  ExpectNothingIsLost(track);
  EXPECT_GE(track.views.size(), 178u);
  EXPECT_LT(WorstTurn(track, record), 0.2);
}

// Small squares a metre apart: the tilt of each alone puts the others far off.
TEST(TrackPoses, LosesNothingOfSeveralMarkersThatAgree) {
  const MarkerMap map = FourMarkers();
  const SyntheticRecord record = MakeRecord(map, 400, 0.3, 0.3, 13);
  ASSERT_EQ(record.detections.size(), 1600u);
  const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
  ExpectNothingIsLost(track);
  EXPECT_EQ(track.views.size(), 400u);
  EXPECT_THAT(track.rejected, IsEmpty());
}

// One false decode in each frame of quiet corners costs that one, and neither the frame nor the
// markers next to it.
TEST(TrackPoses, SetsAsideOneWildMarkerOfAFrameAlone) {
  for (const std::size_t num_markers : {4, 3}) {
    MarkerMap map = FourMarkers();
    map.markers.resize(num_markers);
    SyntheticRecord record = MakeRecord(map, 200, 0.3, 0.05, 15);
    ASSERT_EQ(record.detections.size(), 200 * num_markers);
    std::mt19937 random(4);
    std::vector<int> wild;
    for (std::size_t i = 0; i < 200; ++i) {
      const std::size_t index = num_markers * i + i % num_markers;
      wild.push_back(static_cast<int>(index));
      PutElsewhere(i % 3 == 0 ? 2000.0 : 120.0, &random, &record.detections[index]);
    }
    const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
    ExpectNothingIsLost(track);
    EXPECT_EQ(track.views.size(), 200u);
    std::vector<int> rejected;
    for (const RejectedDetection& one : track.rejected) {
      EXPECT_EQ(one.reason, Rejection::kOutlier);
      rejected.push_back(one.index);
    }
    EXPECT_EQ(rejected, wild);
    EXPECT_LT(std::abs(track.corner_sigma - 0.05), 5.0 * track.corner_sigma_std);
  }
}

// Frames by turns show two markers and two others, whose survey is 3 cm off: the pose jumps by
// more than its corners allow, and is no outlier.
TEST(TrackPoses, KeepsFramesThatTheSurveyMakesJump) {
  MarkerMap map = FourMarkers();
  SyntheticRecord record = MakeRecord(map, 200, 0.3, 0.3, 14);
  std::erase_if(record.detections, [&](const Detection& detection) {
    const auto frame = std::lower_bound(record.time.begin(), record.time.end(), detection.time) -
                       record.time.begin();
    return detection.tag_id / 2 != frame % 2;
  });
  for (const int i : {2, 3}) map.markers[i].world_from_tag.translation.z() += 0.03;
  const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
  ExpectNothingIsLost(track);
  EXPECT_EQ(track.views.size(), 200u);
}

// What it costs to keep a frame grows with its markers; so does what it costs to leave it out.
TEST(TrackPoses, KeepsFramesOfManyMarkers) {
  for (const int num : {20, 28, 36}) {
    const MarkerMap map = WallOfMarkers(num, 8, 0.11, 0.08);
    const SyntheticRecord record = MakeWallRecord(map, 50, 1.5, 0.2, 1);
    const PoseTrack track = TrackPoses(record.detections, WallCamera(), map);
    ExpectNothingIsLost(track);
    EXPECT_EQ(track.views.size(), 50u) << num;
    EXPECT_LT(std::abs(track.corner_sigma - 0.2), 4.0 * track.corner_sigma_std) << num;
  }
}

// Frames at 2.2 times the noise of the others are noisy, and no outliers. Ten markers tell the
// scale of a frame to 1 / sqrt(2 * 74), 20 frames of them to 2 %; four of these.
TEST(TrackPoses, WidensTheNoiseOfFastFrames) {
  const MarkerMap map = WallOfMarkers(10, 5, 0.22, 0.15);
  const SyntheticRecord record = MakeWallRecord(map, 100, 1.5, 0.44, 5);
  const PoseTrack track = TrackPoses(record.detections, WallCamera(), map);
  ExpectNothingIsLost(track);
  ASSERT_EQ(track.views.size(), 100u);
  EXPECT_THAT(track.rejected, IsEmpty());
  double sum = 0.0;
  int num_wide = 0;
  for (int i = 0; i < 100; ++i) {
    const double scale = track.views[i].pose.noise_scale;
    if (i % 5 == 2) sum += scale / 20.0;
    if (i % 5 != 2 && scale > 1.0) ++num_wide;
  }
  EXPECT_NEAR(sum * track.corner_sigma, 0.44, 0.08 * 0.44);
  EXPECT_LE(num_wide, 2);  // one in a thousand of 80
}

// However large a part under a half they are, and though they agree with one another.
TEST(TrackPoses, SetsAsideMarkersThatTheSurveyHasElsewhere) {
  const SyntheticRecord record = MakeWallRecord(TwelveMarkers(), 60, 1.3, 0.2, 1);
  for (const int num_wrong : {1, 4}) {
    const PoseTrack track = TrackPoses(record.detections, WallCamera(), WrongSurvey(num_wrong));
    ExpectNothingIsLost(track);
    EXPECT_EQ(track.views.size(), 60u);
    int num_of_wrong = 0;
    for (const Detection& one : record.detections) num_of_wrong += one.tag_id >= 12 - num_wrong;
    EXPECT_EQ(NumRejected(track, Rejection::kOutlier), num_of_wrong);
    for (const RejectedDetection& one : track.rejected) {
      EXPECT_GE(record.detections[one.index].tag_id, 12 - num_wrong);
    }
    EXPECT_LT(std::abs(track.corner_sigma - 0.2), 4.0 * track.corner_sigma_std);
  }
}

TEST(TrackPoses, LosesNoMoreFramesUnderAWiderGate) {
  const MarkerMap map = WallOfMarkers(28, 7, 0.12, 0.08);
  SyntheticRecord record = MakeWallRecord(map, 40, 1.5, 0.5, 3);
  for (std::size_t i = 0; i < record.detections.size(); i += 29) {
    for (Eigen::Vector2d& corner : record.detections[i].corners) corner.x() += 2.0;
  }
  std::size_t most = 0;
  for (const double gate : {2.0, 4.0, 8.0, 16.0, 32.0}) {
    PoseTrackOptions options;
    options.gate = gate;
    const PoseTrack track = TrackPoses(record.detections, WallCamera(), map, options);
    EXPECT_GE(track.views.size(), most) << gate;
    most = track.views.size();
  }
  EXPECT_EQ(most, 40u);
}

TEST(TrackPoses, CountsEverythingThatDoesNotBecomeAPose) {
  MarkerMap map = FourMarkers();
  SyntheticRecord record = MakeRecord(map, 30, 0.2, 0.3, 12);
  ASSERT_EQ(record.detections.size(), 120u);
  map.markers[3].is_surveyed = false;
  auto& detections = record.detections;
  detections[0].tag_id = 9;                                       // frame 0
  std::swap(detections[4].corners[1], detections[4].corners[3]);  // frame 1: mirrored
  detections[9].tag_id = detections[8].tag_id;                    // frame 2: both of them
  for (Eigen::Vector2d& corner : detections[12].corners) corner.x() += 1280.0;
  detections[16].corners[2] = detections[16].corners[0];
  detections.erase(detections.begin() + 20, detections.begin() + 24);  // frame 5 sees nothing
  PoseTrackOptions options;
  options.frame_times = record.time;
  const PoseTrack track = TrackPoses(detections, SyntheticCamera(), map, options);
  ExpectNothingIsLost(track);
  EXPECT_EQ(track.num_frames, 30);
  EXPECT_EQ(track.num_frames_without_tags, 1);
  EXPECT_EQ(NumRejected(track, Rejection::kUnknownId), 1);
  EXPECT_EQ(NumRejected(track, Rejection::kMirrored), 1);
  EXPECT_EQ(NumRejected(track, Rejection::kRepeatedId), 2);
  EXPECT_EQ(NumRejected(track, Rejection::kOffImage), 1);
  EXPECT_EQ(NumRejected(track, Rejection::kNoSquare), 1);
  EXPECT_EQ(NumRejected(track, Rejection::kNotSurveyed), 29);
  const auto remarks = RemarksOn(track, detections);
  EXPECT_THAT(remarks, Contains("1 of 30 frames have no detection."));
  EXPECT_THAT(remarks, Contains("Set aside as unknown id: 1 of 116 detections: tags 9 (1 time)."));
  EXPECT_THAT(remarks, Contains(HasSubstr("Set aside as mirrored: 1 of 116")));
}

// The products of such numbers have no sign that means an order.
TEST(TrackPoses, CallsCornersFarOffTheImageThatAndNotMirrored) {
  SyntheticRecord record = MakeRecord(FourMarkers(), 30, 0.2, 0.3, 12);
  for (int corner = 0; corner < 4; ++corner) {
    for (const double far : {-1e300, -1e5, 1e5, 1e300}) {
      auto detections = record.detections;
      detections[0].corners[corner].y() = far;
      const PoseTrack track = TrackPoses(detections, SyntheticCamera(), FourMarkers());
      ExpectNothingIsLost(track);
      EXPECT_EQ(NumRejected(track, Rejection::kOffImage), 1) << corner << " at " << far;
      EXPECT_EQ(NumRejected(track, Rejection::kMirrored), 0) << corner << " at " << far;
    }
  }
}

// A fisheye looks past 90 degrees, where a square of its own proposes no pose: that, and no
// contradiction, is why frames with nothing else have none.
TEST(TrackPoses, TellsDetectionsBeyond90DegreesFromOutliers) {
  const CameraModel fisheye = {.width = 1280,
                               .height = 960,
                               .fx = 300.0,
                               .fy = 300.0,
                               .cx = 640.0,
                               .cy = 480.0,
                               .lens = LensModel::kEquidistant,
                               .coefficients = {}};
  const MarkerMap map = SingleMarker();
  std::vector<Detection> detections;
  for (int i = 0; i < 20; ++i) {
    // Two metres away, facing the camera, first 1.2 rad off its axis, then 1.7.
    const double angle = i < 10 ? 1.2 : 1.7;
    Eigen::Matrix3d camera_from_tag;
    camera_from_tag << std::cos(angle), 0.0, std::sin(angle), 0.0, 1.0, 0.0, -std::sin(angle), 0.0,
        std::cos(angle);
    Detection detection;
    detection.time = 0.1 * i;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d x_camera =
          camera_from_tag *
          (CornersInTag(map.markers[0].size)[corner] + Eigen::Vector3d(0.0, 0.0, 2.0));
      detection.corners[corner] = Project(fisheye, x_camera);
    }
    detections.push_back(detection);
  }
  const PoseTrack track = TrackPoses(detections, fisheye, map);
  ExpectNothingIsLost(track);
  EXPECT_EQ(track.views.size(), 10u);
  EXPECT_EQ(NumRejected(track, Rejection::kBeyondRight), 10);
  EXPECT_THAT(RemarksOn(track, detections),
              Contains("Set aside as beyond 90 degrees: 10 of 20 detections: tags 0 (10 times)."));
}

TEST(TrackPoses, RefusesCornersInAnotherOrder) {
  const MarkerMap map = SingleMarker();
  SyntheticRecord record = MakeRecord(map, 20, 0.2, 0.3, 12);
  for (Detection& detection : record.detections) {
    std::reverse(detection.corners.begin(), detection.corners.end());
  }
  EXPECT_THAT(ErrorFrom([&] {
                PoseTrackOptions options;
                options.name = "log/detections.csv";
                TrackPoses(record.detections, SyntheticCamera(), map, options);
              }),
              StartsWith("log/detections.csv: the corners of 20 of 20 run clockwise in the image"));
}

TEST(TrackPoses, RefusesTheCalibrationOfAnotherSize) {
  const MarkerMap map = SingleMarker();
  const SyntheticRecord record = MakeRecord(map, 20, 0.2, 0.3, 12);
  CameraModel camera = SyntheticCamera();
  camera.width /= 2;
  camera.height /= 2;
  camera.cx /= 2.0;
  camera.cy /= 2.0;
  EXPECT_THAT(ErrorFrom([&] { TrackPoses(record.detections, camera, map); }),
              HasSubstr("lie outside the camera's image of 640 x 480 pixels"));
}

TEST(TrackPoses, IsEmptyWithoutAnyKnownTag) {
  MarkerMap map = SingleMarker();
  const SyntheticRecord record = MakeRecord(map, 20, 0.2, 0.3, 12);
  map.markers[0].id = 5;
  const PoseTrack track = TrackPoses(record.detections, SyntheticCamera(), map);
  ExpectNothingIsLost(track);
  EXPECT_THAT(track.views, IsEmpty());
  EXPECT_TRUE(std::isnan(track.corner_sigma));
}

}  // namespace
}  // namespace fathom
