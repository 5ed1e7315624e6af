// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/marker_map.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

CameraModel Pinhole() {
  return {.width = 640, .height = 480, .fx = 500.0, .fy = 400.0, .cx = 320.0, .cy = 240.0};
}

// A wall at z = 0 of the world whose axes are those of the tag; the camera looks at it from z = -2.
const Pose kBeforeTheWall = {Eigen::Quaterniond::Identity(), {0.0, 0.0, -2.0}};

// Each corner by hand: 0.1 m is 25 px across and 20 px down at 2 m.
TEST(ObserveCorners, GoesAroundFromTheBottomLeft) {
  const MarkerMap map = {{{.id = 7, .size = 0.2, .family = "tag36h11", .world_from_tag = {}}}};
  const auto detections = ObserveCorners(Pinhole(), map, kBeforeTheWall, 1.5);
  ASSERT_EQ(detections.size(), 1u);
  EXPECT_EQ(detections[0].tag_id, 7);
  EXPECT_EQ(detections[0].time, 1.5);
  EXPECT_TRUE(detections[0].corners[0].isApprox(Eigen::Vector2d(295.0, 260.0)));
  EXPECT_TRUE(detections[0].corners[1].isApprox(Eigen::Vector2d(345.0, 260.0)));
  EXPECT_TRUE(detections[0].corners[2].isApprox(Eigen::Vector2d(345.0, 220.0)));
  EXPECT_TRUE(detections[0].corners[3].isApprox(Eigen::Vector2d(295.0, 220.0)));
}

TEST(ObserveCorners, LeavesOutWhatTheCameraDoesNotSee) {
  Marker seen = {.id = 1, .size = 0.2, .family = "tag36h11", .world_from_tag = {}};
  Marker cut_off = seen;
  cut_off.id = 2;
  cut_off.world_from_tag.translation.x() = 1.25;  // its middle lies on the edge of the image
  Marker behind = seen;
  behind.id = 3;
  behind.world_from_tag.translation.z() = -4.0;
  Marker from_behind = seen;
  from_behind.id = 4;
  from_behind.world_from_tag.rotation = Eigen::Quaterniond(0.0, 0.0, 1.0, 0.0);  // half turn, y
  const auto detections =
      ObserveCorners(Pinhole(), {{seen, cut_off, behind, from_behind}}, kBeforeTheWall);
  ASSERT_EQ(detections.size(), 1u);
  EXPECT_EQ(detections[0].tag_id, 1);
}

TEST(MarkerMap, FindsAMarkerByItsId) {
  const MarkerMap map = {{{.id = 7, .size = 0.2, .family = "tag36h11", .world_from_tag = {}},
                          {.id = 3, .size = 0.4, .family = "tag16h5", .world_from_tag = {}},
                          {.id = 9, .size = 0.4, .family = "tag36h11", .world_from_tag = {}}}};
  ASSERT_NE(map.Find(3), nullptr);
  EXPECT_EQ(map.Find(3)->size, 0.4);
  EXPECT_EQ(map.Find(5), nullptr);
  EXPECT_EQ(map.Families(), (std::vector<std::string>{"tag36h11", "tag16h5"}));
}

}  // namespace
}  // namespace fathom
