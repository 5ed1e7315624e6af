// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/camera_model.h"

#include <random>
#include <vector>

#include <ceres/jet.h>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

namespace fathom {
namespace {

CameraModel Camera(LensModel lens, std::array<double, 8> coefficients) {
  return {.width = 1280,
          .height = 960,
          .fx = 812.5,
          .fy = 808.25,
          .cx = 633.1,
          .cy = 487.4,
          .lens = lens,
          .coefficients = coefficients};
}

// Strong lenses, every coefficient at work.
std::vector<CameraModel> Cameras() {
  return {Camera(LensModel::kNone, {}),
          Camera(LensModel::kPlumbBob, {-0.21, 0.06, 0.0013, -0.0021, -0.011}),
          Camera(LensModel::kRationalPolynomial,
                 {0.61, 0.12, -0.0011, 0.0007, 0.013, 0.92, 0.27, 0.041}),
          Camera(LensModel::kEquidistant, {-0.017, 0.0042, -0.0035, 0.0009})};
}

std::vector<Eigen::Vector3d> Points() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> slope(-0.7, 0.7), depth(0.3, 9.0);
  std::vector<Eigen::Vector3d> points = {{0.0, 0.0, 2.0}};
  for (int i = 0; i < 200; ++i) {
    const double z = depth(random);
    points.emplace_back(slope(random) * z, 0.7 * slope(random) * z, z);
  }
  return points;
}

Eigen::Vector2d ProjectByOpenCv(const CameraModel& camera, const Eigen::Vector3d& x_camera) {
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const std::vector<cv::Point3d> points = {{x_camera.x(), x_camera.y(), x_camera.z()}};
  const auto& k = camera.coefficients;
  std::vector<cv::Point2d> pixels;
  const cv::Vec3d zero(0, 0, 0);
  if (camera.lens == LensModel::kEquidistant) {
    cv::fisheye::projectPoints(
        points, pixels, zero, zero, matrix, std::vector<double>(k.begin(), k.begin() + 4));
  } else {
    cv::projectPoints(points, zero, zero, matrix, std::vector<double>(k.begin(), k.end()), pixels);
  }
  return {pixels[0].x, pixels[0].y};
}

TEST(CameraModel, ProjectsAsOpenCvDoes) {
  for (const CameraModel& camera : Cameras()) {
    for (const Eigen::Vector3d& point : Points()) {
      const Eigen::Vector2d difference = Project(camera, point) - ProjectByOpenCv(camera, point);
      EXPECT_LT(difference.norm(), 1e-9) << "lens " << static_cast<int>(camera.lens);
    }
  }
}

// Central differences of step h are exact to h^2 times the third derivative, some 1e4 px, and to
// rounding, 1e-13 / h.
TEST(CameraModel, HasTheDerivativesOfItsFiniteDifferences) {
  using Jet = ceres::Jet<double, 3>;
  constexpr double kStep = 1e-5;
  for (const CameraModel& camera : Cameras()) {
    for (const Eigen::Vector3d& ray : Points()) {
      const Eigen::Vector3d point = ray / ray.z();
      Eigen::Matrix<Jet, 3, 1> jets;
      for (int i = 0; i < 3; ++i) jets[i] = Jet(point[i], i);
      const Eigen::Matrix<Jet, 2, 1> pixel = Project(camera, jets);
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
        const Eigen::Vector2d slope =
            (Project<double>(camera, point + step) - Project<double>(camera, point - step)) /
            (2.0 * kStep);
        EXPECT_NEAR(pixel[0].v[i], slope.x(), 1e-5);
        EXPECT_NEAR(pixel[1].v[i], slope.y(), 1e-5);
      }
    }
  }
}

TEST(CameraModel, FindsTheRayOfAPixel) {
  for (const CameraModel& camera : Cameras()) {
    int num_in_view = 0;
    for (const Eigen::Vector3d& point : Points()) {
      if (!IsInView(camera, point)) continue;
      ++num_in_view;
      const auto ray = RayOf(camera, Project(camera, point));
      ASSERT_TRUE(ray.has_value());
      EXPECT_LT((*ray - point.normalized()).norm(), 1e-9);
    }
    EXPECT_GT(num_in_view, 100);
  }
}

TEST(CameraModel, FisheyeSeesBehindItsOwnPlane) {
  CameraModel camera = Camera(LensModel::kEquidistant, {});
  camera.fx = camera.fy = 300.0;
  // 100 degrees off the axis, to the right: 300 px times the angle.
  const double angle = 100.0 / 180.0 * M_PI;
  const Eigen::Vector3d point(std::sin(angle), 0.0, std::cos(angle));
  EXPECT_NEAR(Project(camera, point).x(), camera.cx + 300.0 * angle, 1e-9);
  const auto ray = RayOf(camera, Project(camera, point));
  ASSERT_TRUE(ray.has_value());
  EXPECT_LT((*ray - point).norm(), 1e-9);
}

// r (1 + k1 r^2) with k1 = -0.3 turns back at r = 1 / sqrt(0.9).
TEST(CameraModel, KnowsWhereTheLensFoldsBack) {
  const CameraModel camera = Camera(LensModel::kPlumbBob, {-0.3});
  EXPECT_NEAR(std::tan(LargestAngle(camera)), 1.0 / std::sqrt(0.9), 1e-6);
  // Far outside, the formula comes back onto the image.
  const Eigen::Vector3d outside(1.8, 0.0, 1.0);
  EXPECT_TRUE(camera.Contains(Project(camera, outside)));
  EXPECT_FALSE(IsInView(camera, outside));
  EXPECT_FALSE(IsInView(camera, {0.1, 0.1, -1.0}));
  // No ray is drawn further out than at the turn, r (1 - 0.3 r^2) = 0.703 focal lengths.
  EXPECT_TRUE(RayOf(camera, {camera.cx + 0.70 * camera.fx, camera.cy}).has_value());
  EXPECT_FALSE(RayOf(camera, {camera.cx + 0.71 * camera.fx, camera.cy}).has_value());
}

TEST(CameraModel, TakesTheOuterPixelsWhole) {
  const CameraModel camera = Camera(LensModel::kNone, {});
  EXPECT_TRUE(camera.Contains({-0.5, 0.0}));
  EXPECT_TRUE(camera.Contains({1279.5, 959.5}));
  EXPECT_FALSE(camera.Contains({-0.51, 0.0}));
  EXPECT_FALSE(camera.Contains({3.0, 959.51}));
  EXPECT_FALSE(camera.Contains({std::nan(""), 3.0}));
}

}  // namespace
}  // namespace fathom
