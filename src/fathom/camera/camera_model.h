// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Core>

namespace fathom {

// How a lens bends the ray of a point (x, y, z) of the camera frame; docs/vision.md (1) to (3).
enum class LensModel {
  // a = x/z, b = y/z.
  kNone,

  // plumb_bob of ROS, radtan of Kalibr, the default of OpenCV. Coefficients k1 k2 p1 p2 k3;
  // r^2 = a^2 + b^2, g = 1 + k1 r^2 + k2 r^4 + k3 r^6:
  //   a' = a g + 2 p1 a b + p2 (r^2 + 2 a^2)
  //   b' = b g + p1 (r^2 + 2 b^2) + 2 p2 a b
  kPlumbBob,

  // rational_polynomial of ROS. Coefficients k1 k2 p1 p2 k3 k4 k5 k6: plumb_bob with g divided by
  // 1 + k4 r^2 + k5 r^4 + k6 r^6.
  kRationalPolynomial,

  // equidistant of ROS and Kalibr, cv::fisheye. Coefficients k1 k2 k3 k4; theta is the angle
  // between ray and optical axis:
  //   r' = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8) away from the centre
  kEquidistant,
};

// A calibrated camera: where it draws a point of its optical frame (x right, y down, z ahead).
//
//   u = fx a' + cx,   v = fy b' + cy       pixels, the centre of the first at (0, 0)
//
// A camera in water behind a flat port is none of these: refraction moves the optical centre with
// the angle. Calibrated in water, plumb_bob takes up most of it at one working distance.
struct CameraModel {
  int width = 0;   // [px]
  int height = 0;  // [px]
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  LensModel lens = LensModel::kNone;
  std::array<double, 8> coefficients = {};  // in the order of the lens; the rest 0

  // Whether a pixel lies on the image, its outer pixels taken whole.
  bool Contains(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.x() <= width - 0.5 && pixel.y() >= -0.5 &&
           pixel.y() <= height - 0.5;
  }
};

// The pixel of a point in the camera frame, for double and ceres::Jet alike. The point must be
// ahead (z > 0; with kEquidistant anywhere but straight behind); see IsInView for what the formula
// gives beyond the lens' field.
template <typename T>
Eigen::Matrix<T, 2, 1> Project(const CameraModel& camera, const Eigen::Matrix<T, 3, 1>& x_camera) {
  const std::array<double, 8>& k = camera.coefficients;
  const T& x = x_camera[0];
  const T& y = x_camera[1];
  const T& z = x_camera[2];
  T a, b;
  if (camera.lens == LensModel::kEquidistant) {
    using std::atan2;
    using std::sqrt;
    const T square = x * x + y * y;
    if (square < 1e-24 * z * z) {  // on the axis: theta / r is 1 / z
      a = x / z;
      b = y / z;
    } else {
      const T r = sqrt(square);
      const T theta = atan2(r, z);
      const T t = theta * theta;
      const T scale = theta * (1.0 + t * (k[0] + t * (k[1] + t * (k[2] + t * k[3])))) / r;
      a = scale * x;
      b = scale * y;
    }
  } else {
    const T p = x / z;
    const T q = y / z;
    const T s = p * p + q * q;
    T g = 1.0 + s * (k[0] + s * (k[1] + s * k[4]));
    if (camera.lens == LensModel::kRationalPolynomial) {
      g /= 1.0 + s * (k[5] + s * (k[6] + s * k[7]));
    }
    a = p * g + 2.0 * k[2] * p * q + k[3] * (s + 2.0 * p * p);
    b = q * g + k[2] * (s + 2.0 * q * q) + 2.0 * k[3] * p * q;
  }
  return {camera.fx * a + camera.cx, camera.fy * b + camera.cy};
}

// The angle from the optical axis up to which the lens model is one to one [rad]: beyond it the
// polynomial folds back, and points from outside would be drawn on the image. Tangential terms are
// left out. At most pi/2 for lenses that divide by z, pi for kEquidistant.
double LargestAngle(const CameraModel& camera);

// Whether the camera sees the point: within LargestAngle() and on the image.
bool IsInView(const CameraModel& camera, const Eigen::Vector3d& x_camera);

// The direction from which a pixel is seen, of length 1; the inverse of Project, by Newton's
// method to 1e-9 px. Nothing if no ray within LargestAngle() is drawn there.
std::optional<Eigen::Vector3d> RayOf(const CameraModel& camera, const Eigen::Vector2d& pixel);

// The same for many pixels of one camera: `largest_angle` is LargestAngle(camera).
std::optional<Eigen::Vector3d> RayOf(const CameraModel& camera,
                                     const Eigen::Vector2d& pixel,
                                     double largest_angle);

}  // namespace fathom
