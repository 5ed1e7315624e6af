// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/camera_rig.h"
#include "fathom/camera/detections_file.h"
#include "fathom/marker_trajectory/marker_trajectory.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "real_data.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Distance of two tags of a board from centre to centre, less the 0.150 m that they were hung at.
double Excess(const MarkerMap& map, int a, int b) {
  const Eigen::Vector3d step =
      map.Find(a)->world_from_tag.translation - map.Find(b)->world_from_tag.translation;
  return std::abs(step.norm() - 0.150);
}

class RealWalls : public OnRealData {};

// tag_walls/tagslam_13, its first 55 s: boards of 2 x 3 tags on the walls of a hall, of which one
// is surveyed. Some frames are half again as noisy as the others.
TEST_F(RealWalls, ArePlacedTagByTag) {
  const auto log = folder_ / "tag_walls" / "tagslam_13";
  constexpr double kEnd = 55.0;  // [s]
  const CameraRig rig = ReadCameraRig(log);
  std::vector<Detection> detections = ReadDetections(log / "detections.csv");
  std::erase_if(detections, [](const Detection& one) { return one.time > kEnd; });
  const MarkerTrack track = TrackMarkers(detections, rig.camera, rig.map, rig.body_from_camera);
  ASSERT_TRUE(track.IsUsable()) << track.message;
  EXPECT_EQ(track.pnp.num_frames, 118);
  EXPECT_EQ(track.world_from_camera.size(), 118u);
  EXPECT_EQ(track.estimated_ids.size(), 21u);
  EXPECT_TRUE(track.moved_markers.empty());
  std::vector<double> excess;
  for (const int id : track.estimated_ids) {
    const auto add = [&](int neighbour) {
      if (std::ranges::count(track.estimated_ids, neighbour) > 0) {
        excess.push_back(Excess(track.map, id, neighbour));
      }
    };
    if (id % 3 != 2) add(id + 1);
    if (id % 6 < 3) add(id + 3);
  }
  ASSERT_GE(excess.size(), 10u);
  std::ranges::sort(excess);
  EXPECT_LT(excess[excess.size() / 2], 0.001);
}

}  // namespace
}  // namespace fathom
