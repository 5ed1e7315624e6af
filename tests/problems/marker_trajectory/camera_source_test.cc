// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/camera_source.h"

#include "fathom/base/input_error.h"
#include "fathom/base/output_file.h"
#include "fathom/signal/signals.h"
#include "fathom/vision/detections_file.h"

#include "synthetic_views.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr char kCamera[] =
    "cam0: {camera_model: pinhole, distortion_model: radtan, intrinsics: [640, 645, 633, 487], "
    "distortion_coeffs: [-0.11, 0.02, 0.0004, -0.0003], resolution: [1280, 960]}\n";

// A camera that swings to and fro before one marker, as a log folder without any pose.
std::filesystem::path Folder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder =
      std::filesystem::path(FATHOM_SCRATCH_DIR) / "camera_source_test" / test->name();
  std::filesystem::remove_all(folder);
  CameraModel camera = SyntheticCamera();
  camera.coefficients[4] = 0.0;
  std::vector<Detection> detections;
  for (int i = 0; i < 600; ++i) {
    const double t = 0.1 * i;
    Pose pose = OnTheWall(0.0, 0.0);
    pose.translation.x() = 0.3 * std::sin(0.5 * t);
    pose.rotation = pose.rotation * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY());
    for (const Detection& one : ObserveCorners(camera, SingleMarker(), pose, t)) {
      detections.push_back(one);
    }
  }
  std::mt19937 random(6);
  AddNoise(0.2, &random, &detections);
  WriteFile(folder / "log.yaml", "name: swing\ndof: surge\n");
  WriteFile(folder / "command.csv", "t,tau_surge\n0,1\n30,-1\n");
  WriteDetections(folder / "detections.csv", detections);
  WriteFile(folder / "camera.yaml", kCamera);
  // x ahead, so that the tag's axes are (0, 1, 0), (0, 0, 1), (1, 0, 0).
  WriteFile(folder / "tags.yaml",
            "family: tag36h11\ntags: [{id: 0, size: 0.4, world_from_tag: {position: [3, 0, 0], "
            "quaternion: [0.5, 0.5, 0.5, 0.5]}}]\n");
  WriteFile(folder / "mount.yaml",
            "body_from_camera: {position: [0.5, 0, 0], quaternion: [0.5, 0.5, 0.5, 0.5]}\n");
  return folder;
}

TEST(CameraSource, TurnsDetectionsIntoTheMotionOfTheBody) {
  Log log = ReadLog(Folder());
  ASSERT_TRUE(NeedsTracking(log));
  TrackDetections(&log);
  ASSERT_TRUE(log.pose);
  EXPECT_FALSE(NeedsTracking(log));
  ASSERT_EQ(log.pose->time.size(), 600u);
  EXPECT_THAT(log.remarks, Contains(HasSubstr("600 of 600 frames with detections gave a pose")));
  const Signals signals = SignalsOf(log, Dof::kSurge, {.source = Source::kCamera});
  ASSERT_EQ(signals.train.size(), 1u);
  const Segment& segment = signals.train[0];
  // The body looks 0.3 rad off north, the camera swings along north, and that is surge's
  // coordinate. Its errors are those that pose.csv reports, here with the scatter of 600 of them.
  ASSERT_EQ(segment.position.size(), segment.time.size());
  const std::vector<double>& reported = *log.pose->Find("sx");
  double mean = 0.0, mean_reported = 0.0;
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    mean += (segment.position[i] - 0.3 * std::sin(0.5 * segment.time[i])) / 600.0;
    mean_reported += reported[i] / 600.0;
  }
  double square = 0.0;
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    const double error = segment.position[i] - 0.3 * std::sin(0.5 * segment.time[i]) - mean;
    square += error * error / 600.0;
  }
  EXPECT_NEAR(std::sqrt(square) / mean_reported, 1.0, 0.15);
  EXPECT_LT(mean_reported, 0.02);
}

TEST(CameraSource, LeavesPosesAlone) {
  Log log = ReadLog(Folder());
  log.pose = Stream{{0.0, 1.0}, {"x"}, {{1.0, 2.0}}};
  TrackDetections(&log);
  EXPECT_EQ(log.pose->time.size(), 2u);
}

TEST(CameraSource, SaysWhyNoTrajectoryCameOfIt) {
  const auto folder = Folder();
  WriteFile(folder / "tags.yaml",
            "family: tag36h11\ntags: [{id: 7, size: 0.4, world_from_tag: {position: [3, 0, 0], "
            "quaternion: [0.5, 0.5, 0.5, 0.5]}}]\n");
  Log log = ReadLog(folder);
  try {
    TrackDetections(&log);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("detections.csv: 0 of 600 frames with detections gave a pose"));
    EXPECT_THAT(error.what(), HasSubstr("Set aside as unknown id: 600 of 600"));
  }
}

}  // namespace
}  // namespace fathom
