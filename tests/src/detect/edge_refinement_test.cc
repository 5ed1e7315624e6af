// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/edge_refinement.h"

#include "fathom/detect/tag_detector.h"
#include "fathom/film/tag_renderer.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "rendered_scene.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

struct Errors {
  int num = 0;  // corners
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();
  double outward = 0.0;  // mean, away from the tag's centre [px]
  double sigma = 0.0;    // per coordinate, about the exact projection [px]
  double stretch = 0.0;  // slope of the tag's error across the image with its place there
};

// Tags that stand upright, a little turned, at places all over the image: the hardest case for a
// detector that looks at whole pixels, and the usual one of a vehicle before a wall.
std::vector<Pose> UprightPoses(int num) {
  std::vector<Pose> poses;
  for (int i = 0; i < num; ++i) {
    const double across = -0.32 + 0.64 * i / (num - 1);
    const double distance = 3.0 + 2.2 * i / num;
    const Eigen::Quaterniond rotation(
        Eigen::AngleAxisd(0.2 * std::sin(1.7 * i), Eigen::Vector3d::UnitY()) *
        Eigen::AngleAxisd(0.003 * std::sin(2.3 * i), Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d tag_in_camera(
        across * distance, 0.1 * std::sin(3.1 * i) * distance, distance);
    poses.push_back({rotation, -(rotation * tag_in_camera)});
  }
  return poses;
}

// Of libapriltag's corners, and of those of FollowSides() from there.
std::array<Errors, 2> ErrorsOn(const CameraModel& camera, const std::string& family, int num) {
  const MarkerMap map = OneMarker(family, 7, 0.4);
  WaterView view;
  view.noise = 2.0;
  view.blur = 0.8;
  view.attenuation = 0.1;
  view.vignetting = 0.3;
  const TagRenderer renderer(camera, map, view);
  TagDetector detector(map.Families());
  std::array<Errors, 2> errors;
  std::array<double, 2> across_error = {}, squares = {};
  double across_square = 0.0;
  std::uint64_t seed = 0;
  for (const Pose& pose : UprightPoses(num)) {
    const auto truth = ObserveCorners(camera, map, pose);
    EXPECT_EQ(truth.size(), 1);
    const GrayImage image = renderer.Render(std::array{pose}, ++seed);
    for (const TagSighting& sighting : detector.Detect(image)) {
      if (sighting.hamming != 0 || truth.size() != 1) continue;
      const auto followed = FollowSides(image, camera, LargestAngle(camera), sighting.corners);
      EXPECT_TRUE(followed.has_value());
      if (!followed) continue;
      Eigen::Vector2d centre = Eigen::Vector2d::Zero();
      for (const Eigen::Vector2d& corner : truth[0].corners) centre += 0.25 * corner;
      const double place = centre.x() - camera.cx;
      across_square += 4.0 * place * place;
      for (int which : {0, 1}) {
        Errors& of = errors[which];
        const auto& corners = which == 0 ? sighting.corners : *followed;
        for (int i = 0; i < 4; ++i) {
          const Eigen::Vector2d error = corners[i] - truth[0].corners[i];
          ++of.num;
          of.bias += error;
          of.outward += error.dot((truth[0].corners[i] - centre).normalized());
          squares[which] += error.squaredNorm();
          across_error[which] += error.x() * place;
        }
      }
    }
  }
  for (int which : {0, 1}) {
    Errors& of = errors[which];
    of.bias /= of.num;
    of.outward /= of.num;
    of.sigma = std::sqrt(squares[which] / (2.0 * of.num));
    of.stretch = across_error[which] / across_square;
    std::printf("%s: %d corners, bias (%.4f, %.4f), outward %.4f, sigma %.4f px, stretch %.1e\n",
                which == 0 ? "libapriltag" : "followed   ",
                of.num,
                of.bias.x(),
                of.bias.y(),
                of.outward,
                of.sigma,
                of.stretch);
  }
  return errors;
}

// 96 corners of 0.03 px: a mean is known to 0.003 px, a stretch over +- 110 px to 3e-5.
TEST(FollowSides, FindsTheCornersOfUprightTagsUnderABentLens) {
  const auto [libapriltag, followed] = ErrorsOn(BarrelCamera(), "tag36h11", 24);
  EXPECT_EQ(followed.num, 96);
  EXPECT_LT(followed.bias.cwiseAbs().maxCoeff(), 0.01);
  EXPECT_LT(std::abs(followed.outward), 0.01);
  EXPECT_LT(followed.sigma, 0.04);
  EXPECT_LT(followed.sigma, 0.5 * libapriltag.sigma);
  EXPECT_LT(std::abs(followed.stretch), 1.2e-4);
  EXPECT_GT(libapriltag.stretch, 2e-4);  // straight lines through bent sides
}

// A white border about a black one: it gets darker where others get brighter.
TEST(FollowSides, FindsTheCornersOfReversedBorders) {
  const auto [libapriltag, followed] = ErrorsOn(PlainCamera(), "tagStandard41h12", 12);
  EXPECT_EQ(followed.num, 48);
  EXPECT_LT(std::abs(followed.outward), 0.02);
  EXPECT_LT(followed.sigma, 0.5 * libapriltag.sigma);
}

TEST(FollowSides, FindsNothingWhereNothingIs) {
  const CameraModel camera = PlainCamera();
  const std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d(100.0, 200.0),
                                                  Eigen::Vector2d(180.0, 200.0),
                                                  Eigen::Vector2d(180.0, 120.0),
                                                  Eigen::Vector2d(100.0, 120.0)};
  const double largest_angle = LargestAngle(camera);
  EXPECT_FALSE(FollowSides(
      GrayImage(camera.width, camera.height, 90), camera, largest_angle, corners));  // bare
  GrayImage image(camera.width, camera.height, 200);
  for (int v = 120; v <= 200; ++v) {
    for (int u = 100; u <= 180; ++u) image.At(u, v) = 20;
  }
  const auto found = FollowSides(image, camera, largest_angle, corners);
  ASSERT_TRUE(found);
  // Pixels 100 to 180 are dark: the sides lie half a pixel outside of their centres.
  EXPECT_LT(((*found)[0] - Eigen::Vector2d(99.5, 200.5)).norm(), 0.02);
  EXPECT_LT(((*found)[2] - Eigen::Vector2d(180.5, 119.5)).norm(), 0.02);
  auto elsewhere = corners;
  for (Eigen::Vector2d& corner : elsewhere) corner.x() -= 101.0;
  EXPECT_FALSE(FollowSides(image, camera, largest_angle, elsewhere));  // off the image
}

}  // namespace
}  // namespace fathom
