// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/camera_model.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace fathom {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Distance from the centre at which a ray is drawn, in focal lengths, without tangential terms, and
// its derivative. Of the angle for kEquidistant, of its tangent for the others.
struct Radius {
  double value;
  double slope;
};

Radius RadiusOf(const CameraModel& camera, double r) {
  const auto& k = camera.coefficients;
  const double s = r * r;
  if (camera.lens == LensModel::kEquidistant) {
    return {r * (1.0 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3])))),
            1.0 + s * (3.0 * k[0] + s * (5.0 * k[1] + s * (7.0 * k[2] + s * 9.0 * k[3])))};
  }
  const double numerator = 1.0 + s * (k[0] + s * (k[1] + s * k[4]));
  const double numerator_slope = 2.0 * r * (k[0] + s * (2.0 * k[1] + s * 3.0 * k[4]));
  if (camera.lens != LensModel::kRationalPolynomial) {
    return {r * numerator, numerator + r * numerator_slope};
  }
  const double denominator = 1.0 + s * (k[5] + s * (k[6] + s * k[7]));
  const double denominator_slope = 2.0 * r * (k[5] + s * (2.0 * k[6] + s * 3.0 * k[7]));
  const double g = numerator / denominator;
  return {r * g, g + r * (numerator_slope - g * denominator_slope) / denominator};
}

// The direction of the ray with coordinates (p, q): tangents of the ray, or, for kEquidistant, the
// angle from the axis along each image axis, so that (0, 0) is no special point.
Eigen::Vector3d DirectionOf(const CameraModel& camera, const Eigen::Vector2d& ray) {
  if (camera.lens != LensModel::kEquidistant) return {ray.x(), ray.y(), 1.0};
  const double theta = ray.norm();
  const double sinc = theta < 1e-8 ? 1.0 : std::sin(theta) / theta;
  return {sinc * ray.x(), sinc * ray.y(), std::cos(theta)};
}

}  // namespace

double LargestAngle(const CameraModel& camera) {
  const bool is_fisheye = camera.lens == LensModel::kEquidistant;
  const auto is_rising = [&](double angle) {
    const Radius radius = RadiusOf(camera, is_fisheye ? angle : std::tan(angle));
    return radius.value > 0.0 && radius.slope > 0.0;
  };
  const double end = is_fisheye ? kPi : 0.5 * kPi;
  constexpr int kNumSteps = 512;
  double inside = 0.0;
  for (int i = 1; i <= kNumSteps; ++i) {
    double outside = end * i / kNumSteps;
    if (i < kNumSteps && is_rising(outside)) {
      inside = outside;
      continue;
    }
    if (i == kNumSteps && is_rising(end * (1.0 - 1e-6))) return end;
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = 0.5 * (inside + outside);
      (is_rising(middle) ? inside : outside) = middle;
    }
    break;
  }
  return inside;
}

bool IsInView(const CameraModel& camera, const Eigen::Vector3d& x_camera) {
  const double angle = std::atan2(std::hypot(x_camera.x(), x_camera.y()), x_camera.z());
  if (camera.lens != LensModel::kEquidistant && !(x_camera.z() > 0.0)) return false;
  return angle < LargestAngle(camera) && camera.Contains(Project(camera, x_camera));
}

std::optional<Eigen::Vector3d> RayOf(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  return RayOf(camera, pixel, LargestAngle(camera));
}

std::optional<Eigen::Vector3d> RayOf(const CameraModel& camera,
                                     const Eigen::Vector2d& pixel,
                                     double largest_angle) {
  constexpr int kMostIterations = 50;
  constexpr double kTolerance = 1e-9;  // [px]
  constexpr double kStep = 1e-6;       // of the central differences
  const Eigen::Vector2d start((pixel.x() - camera.cx) / camera.fx,
                              (pixel.y() - camera.cy) / camera.fy);
  const double largest =
      camera.lens == LensModel::kEquidistant ? largest_angle : std::tan(largest_angle);
  const auto miss = [&](const Eigen::Vector2d& ray) -> Eigen::Vector2d {
    return Project(camera, DirectionOf(camera, ray)) - pixel;
  };
  // The lens' field is a disc; a start outside is drawn to its rim.
  const auto into_field = [&](Eigen::Vector2d ray) {
    const double norm = ray.norm();
    if (!(norm < largest)) ray *= 0.999 * largest / norm;
    return ray;
  };

  Eigen::Vector2d ray = into_field(start);
  Eigen::Vector2d error = miss(ray);
  for (int i = 0; i < kMostIterations && !(error.norm() < kTolerance); ++i) {
    Eigen::Matrix2d jacobian;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
      jacobian.col(axis) = (miss(ray + step) - miss(ray - step)) / (2.0 * kStep);
    }
    const Eigen::Vector2d step = -jacobian.fullPivLu().solve(error);
    // Newton, halved until it comes nearer.
    double share = 1.0;
    Eigen::Vector2d next = into_field(ray + step);
    while (share > 1e-3 && !(miss(next).norm() < error.norm())) {
      share *= 0.5;
      next = into_field(ray + share * step);
    }
    const Eigen::Vector2d next_error = miss(next);
    if (!(next_error.norm() < error.norm())) break;
    ray = next;
    error = next_error;
  }
  // What rounding leaves of a pixel far from the centre is still exact.
  if (!(error.norm() < 1e3 * kTolerance) || !(ray.norm() < largest)) return std::nullopt;
  return DirectionOf(camera, ray).normalized();
}

}  // namespace fathom
