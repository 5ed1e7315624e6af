// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/tag_renderer.h"

#include "fathom/base/input_error.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rendered_scene.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// No water, no blur, no noise: black is 0 and white 250, so that grey values are shares of white.
WaterView Plain() {
  WaterView view;
  view.white = 250.0;
  view.black = 0.0;
  view.wall = 250.0;
  view.blur = 0.0;
  view.noise = 0.0;
  return view;
}

// Where the side from bottom-left to top-left of the tag's border crosses the row v, by bisection
// along that side.
double LeftSideAtRow(const CameraModel& camera,
                     const Marker& marker,
                     const Pose& world_from_camera,
                     double v) {
  const Pose camera_from_tag = world_from_camera.Inverse() * marker.world_from_tag;
  double from = -0.5 * marker.size, to = 0.5 * marker.size;
  const auto pixel = [&](double y) {
    const Eigen::Vector3d x_camera = camera_from_tag * Eigen::Vector3d(-0.5 * marker.size, y, 0.0);
    return Project(camera, x_camera);
  };
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (from + to);
    (pixel(middle).y() < v ? from : to) = middle;
  }
  return pixel(from).x();
}

// The place of the first edge from white to black in a row: the pixels to the left of the border's
// middle are white up to there.
double FirstEdge(const GrayImage& image, int u_from, int u_to, int v) {
  double white = 0.0;
  for (int u = u_from; u < u_to; ++u) white += image.At(u, v) / 250.0;
  return u_from - 0.5 + white;
}

TEST(TagRenderer, PutsEdgesWhereTheyAreToAHundredthOfAPixel) {
  const std::vector<CameraModel> cameras = {PlainCamera(), BarrelCamera(), FisheyeCamera()};
  const MarkerMap map = OneMarker("tag36h11", 7, 0.4);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const TagRenderer renderer(cameras[i], map, Plain());
    for (const double turn : {0.0, 0.05, 0.3}) {
      const Pose pose = LookingAt({0.11, -0.07, -1.1}, turn);
      const GrayImage image = renderer.Render(std::array{pose}, 1);
      const auto seen = ObserveCorners(cameras[i], map, pose);
      ASSERT_EQ(seen.size(), 1u);
      const auto& corners = seen[0].corners;
      const double cell = (corners[1] - corners[0]).norm() / 8.0;
      double square = 0.0;
      int num = 0;
      const int first = static_cast<int>(std::max(corners[2].y(), corners[3].y()) + cell);
      const int last = static_cast<int>(std::min(corners[0].y(), corners[1].y()) - cell);
      for (int v = first; v <= last; ++v) {
        const double edge = LeftSideAtRow(cameras[i], map.markers[0], pose, v);
        const int u = static_cast<int>(edge);
        const int reach = static_cast<int>(0.6 * cell);
        const double error = FirstEdge(image, u - reach, u + reach, v) - edge;
        square += error * error;
        // Rounding to whole grey values: up to two pixels of 1/500 each, and the bend of the side
        // within a row.
        EXPECT_NEAR(error, 0.0, 0.01) << "camera " << i << ", turn " << turn << ", row " << v;
        ++num;
      }
      ASSERT_GT(num, 50);
      EXPECT_LT(std::sqrt(square / num), 0.003) << "camera " << i << ", turn " << turn;
    }
  }
}

TEST(TagRenderer, DimsLightByTheWaterItPasses) {
  WaterView view = Plain();
  view.attenuation = 0.7;
  view.veiling_light = 80.0;
  const MarkerMap map = OneMarker("tag36h11", 7, 0.4);
  const TagRenderer renderer(PlainCamera(), map, view);
  for (const double distance : {1.0, 2.5}) {
    const Pose pose = LookingAt({0.0, 0.0, -distance}, 0.0);
    const GrayImage image = renderer.Render(std::array{pose}, 1);
    // On the border's left side, at half the height of the tag: black, (0.175, 0) m off the centre.
    const Eigen::Vector2d pixel = Project(PlainCamera(), Eigen::Vector3d(-0.175, 0.0, distance));
    const double passed = std::exp(-0.7 * std::hypot(0.175, distance));
    EXPECT_NEAR(
        image.At(std::lround(pixel.x()), std::lround(pixel.y())), 80.0 * (1.0 - passed), 1.0);
    // The wall at the left of the image's middle row.
    const CameraModel camera = PlainCamera();
    const double x = distance * (0.0 - camera.cx) / camera.fx;
    const double far = std::exp(-0.7 * std::hypot(x, distance));
    EXPECT_NEAR(image.At(0, std::lround(camera.cy)), 250.0 * far + 80.0 * (1.0 - far), 1.0);
  }
}

TEST(TagRenderer, DarkensTheCorners) {
  WaterView view = Plain();
  view.vignetting = 0.4;
  CameraModel camera = PlainCamera();
  camera.cx = 0.5 * (camera.width - 1);
  camera.cy = 0.5 * (camera.height - 1);
  const TagRenderer renderer(camera, OneMarker("tag36h11", 7, 0.1), view);
  const GrayImage image = renderer.Render(std::array{LookingAt({0.0, 0.0, -2.0}, 0.0)}, 1);
  EXPECT_NEAR(image.At(0, 0), 0.6 * 250.0, 1.0);
  const double half_way = 1.0 - 0.4 * (160.0 * 160.0) / (319.5 * 319.5 + 239.5 * 239.5);
  EXPECT_NEAR(image.At(160, 240), half_way * 250.0, 1.5);
}

TEST(TagRenderer, SmearsEdgesOverTheWayOfTheCamera) {
  // The camera moves by 12 px along u during the exposure: the left edge becomes a ramp of 12 px
  // around its mean place.
  const CameraModel camera = PlainCamera();
  const MarkerMap map = OneMarker("tag36h11", 7, 0.4);
  const double step = 12.0 / camera.fx;  // [m], at a distance of 1 m
  std::vector<Pose> poses;
  const int num = 24;
  for (int i = 0; i < num; ++i) {
    poses.push_back(LookingAt({step * ((i + 0.5) / num - 0.5), 0.0, -1.0}, 0.0));
  }
  const GrayImage image = TagRenderer(camera, map, Plain()).Render(poses, 1);
  const int v = std::lround(camera.cy);
  const double edge = camera.cx - 0.2 * camera.fx;
  for (int u = static_cast<int>(edge) - 10; u <= edge + 10; ++u) {
    const double share = std::clamp(0.5 - (u - edge) / 12.0, 0.0, 1.0);
    // A pixel at the foot of the ramp is a mean over its bend: 1/8 px / 12.
    EXPECT_NEAR(image.At(u, v) / 250.0, share, 0.02) << u;
  }
}

TEST(TagRenderer, BlursByTheWidthAsked) {
  WaterView view = Plain();
  view.blur = 2.0;
  const CameraModel camera = PlainCamera();
  const TagRenderer renderer(camera, OneMarker("tag36h11", 7, 0.4), view);
  const GrayImage image = renderer.Render(std::array{LookingAt({0.0, 0.0, -1.0}, 0.0)}, 1);
  const double edge = camera.cx - 0.2 * camera.fx;
  const int v = std::lround(camera.cy);
  for (int u = static_cast<int>(edge) - 6; u <= edge + 6; ++u) {
    // A step seen through a normal curve and a pixel of variance 1/12.
    const double sigma = std::sqrt(4.0 + 1.0 / 12.0);
    EXPECT_NEAR(image.At(u, v) / 250.0, 0.5 * std::erfc((u - edge) / sigma / std::sqrt(2.0)), 0.006)
        << u;
  }
}

TEST(TagRenderer, DoesNotShowTheBackOfAMarker) {
  WaterView view = Plain();
  view.veiling_light = 33.0;
  const TagRenderer renderer(PlainCamera(), OneMarker("tag36h11", 7, 0.4), view);
  // Behind the wall, looking back at it.
  Pose pose;
  pose.translation = {0.0, 0.0, 1.0};
  pose.rotation = Eigen::AngleAxisd(EIGEN_PI, Eigen::Vector3d::UnitY());
  const GrayImage image = renderer.Render(std::array{pose}, 1);
  for (const auto pixel : image.pixels) ASSERT_EQ(pixel, 33);
}

TEST(TagRenderer, LetsANearerMarkerHideOneBehindIt) {
  MarkerMap map = OneMarker("tag36h11", 7, 0.4);
  Marker near = map.markers[0];
  near.id = 8;
  near.size = 0.2;
  near.world_from_tag.translation = {0.0, 0.0, -0.5};
  for (const bool nearer_first : {true, false}) {
    MarkerMap both = map;
    both.markers.insert(nearer_first ? both.markers.begin() : both.markers.end(), near);
    const CameraModel camera = PlainCamera();
    const GrayImage image =
        TagRenderer(camera, both, Plain()).Render(std::array{LookingAt({0, 0, -1.0}, 0.0)}, 1);
    // The near tag's border at (-0.0875, 0) m, 0.5 m away: black, where the far one may be white.
    const Eigen::Vector2d pixel = Project(camera, Eigen::Vector3d(-0.0875, 0.0, 0.5));
    EXPECT_EQ(image.At(std::lround(pixel.x()), std::lround(pixel.y())), 0) << nearer_first;
    // Its white rim, over the far one's black border.
    const Eigen::Vector2d rim = Project(camera, Eigen::Vector3d(-0.1125, 0.0, 0.5));
    EXPECT_EQ(image.At(std::lround(rim.x()), std::lround(rim.y())), 250) << nearer_first;
  }
}

TEST(TagRenderer, RefusesWhatItCannotDraw) {
  WaterView view;
  view.attenuation = -1.0;
  EXPECT_THROW(TagRenderer(PlainCamera(), OneMarker("tag36h11", 7, 0.4), view), InputError);
  EXPECT_THROW(TagRenderer(PlainCamera(), OneMarker("tag36h11", 587, 0.4)), InputError);
  EXPECT_THROW(TagRenderer(PlainCamera(), OneMarker("tag99", 7, 0.4)), InputError);
}

}  // namespace
}  // namespace fathom
