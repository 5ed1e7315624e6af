// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/camera_source.h"

#include "fathom/base/files/output_file.h"
#include "fathom/camera/detections_file.h"
#include "fathom/log/read_log.h"
#include "fathom/signal/signals.h"

#include "error_from.h"
#include "synthetic_views.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr char kCamera[] =
    "cam0: {camera_model: pinhole, distortion_model: radtan, intrinsics: [640, 645, 633, 487], "
    "distortion_coeffs: [-0.11, 0.02, 0.0004, -0.0003], resolution: [1280, 960]}\n";

// A camera that swings to and fro before one marker, as a log folder without any pose.
std::filesystem::path Folder() {
  const auto folder = EmptyTestFolder();
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
  EXPECT_THAT(TextsOf(log.remarks),
              Contains(HasSubstr("600 of 600 frames with detections gave a pose")));
  const Signals signals = SignalsOf(log, Dof::kSurge, {.source = Source::kCamera});
  ASSERT_EQ(signals.train.size(), 1u);
  const Segment& segment = signals.train[0];
  // The body looks 0.3 rad off north and the camera swings along north: so much of that is along
  // surge. The errors are those that pose.csv reports along and across, here with the scatter of
  // 600 of them; in between they hang together by an unknown amount.
  ASSERT_EQ(segment.position.size(), segment.time.size());
  const double along = std::cos(0.3), across = std::sin(0.3);
  const auto swing = [&](double t) { return along * 0.3 * std::sin(0.5 * t); };
  double mean = 0.0, sx = 0.0, sy = 0.0;
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    mean += (segment.position[i] - swing(segment.time[i])) / 600.0;
    sx += (*log.pose->Find("sx"))[i] / 600.0;
    sy += (*log.pose->Find("sy"))[i] / 600.0;
  }
  double square = 0.0;
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    const double error = segment.position[i] - swing(segment.time[i]) - mean;
    square += error * error / 600.0;
  }
  EXPECT_LT(std::sqrt(square), 1.15 * (along * sx + across * sy));
  EXPECT_GT(std::sqrt(square), 0.85 * std::abs(along * sx - across * sy));
  EXPECT_LT(sx, 0.02);
  // What moved along the world's axes has the velocity of the body's.
  double miss = 0.0, size = 0.0;
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    const double v = along * 0.15 * std::cos(0.5 * segment.time[i]);
    miss += std::abs(segment.velocity[i] - v);
    size += std::abs(v);
  }
  EXPECT_LT(miss, 0.2 * size);
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
  EXPECT_THAT(
      ErrorFrom([&] { TrackDetections(&log); }),
      testing::AllOf(HasSubstr("detections.csv: 0 of 600 frames with detections gave a pose"),
                     HasSubstr("Set aside as unknown id: 600 of 600")));
}

}  // namespace
}  // namespace fathom
