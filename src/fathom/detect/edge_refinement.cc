// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/edge_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

namespace fathom {
namespace {

using Eigen::Vector2d;

constexpr int kNumPasses = 3;           // each centres its windows on the sides of the one before
constexpr double kShortestSide = 20.0;  // [px]
constexpr double kLargestReach = 3.0;   // of a window, to either side [px]

// The reach ends before the next cell of any family's code does, an eighth or more of a side.
double ReachOf(double length) { return std::min(kLargestReach, 0.08 * length); }

// Grey value between pixels; nothing off the image.
std::optional<double> GreyAt(const GrayImage& image, const Vector2d& pixel) {
  const double u = std::floor(pixel.x()), v = std::floor(pixel.y());
  if (!(u >= 0.0 && v >= 0.0 && u + 1.0 < image.width && v + 1.0 < image.height)) return {};
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const double a = pixel.x() - u, b = pixel.y() - v;
  return (1.0 - b) * ((1.0 - a) * image.At(i, j) + a * image.At(i + 1, j)) +
         b * ((1.0 - a) * image.At(i, j + 1) + a * image.At(i + 1, j + 1));
}

// A pixel's ray as (x/z, y/z): where straight things are straight.
std::optional<Vector2d> Unbent(const CameraModel& camera,
                               double largest_angle,
                               const Vector2d& pixel) {
  const auto ray = RayOf(camera, pixel, largest_angle);
  if (!ray || !(ray->z() > 0.0)) return {};
  return Vector2d(ray->head<2>() / ray->z());
}

Vector2d Bent(const CameraModel& camera, const Vector2d& unbent) {
  return Project<double>(camera, unbent.homogeneous());
}

// Where, from `middle` along `across`, the grey value changes most: [px]. Nothing where it changes
// the other way or not at all. `sign`: of the change.
std::optional<double> EdgeAcross(const GrayImage& image,
                                 const Vector2d& middle,
                                 const Vector2d& across,
                                 double reach,
                                 double sign) {
  constexpr double kStep = 0.25;
  constexpr int kHalfPixel = 2;  // steps
  constexpr int kMost = static_cast<int>(kLargestReach / kStep) + kHalfPixel;
  const int num = static_cast<int>(reach / kStep);
  std::array<double, 2 * kMost + 1> grey;
  for (int i = -num - kHalfPixel; i <= num + kHalfPixel; ++i) {
    const auto here = GreyAt(image, middle + kStep * i * across);
    if (!here) return {};
    grey[i + kMost] = *here;
  }
  double sum = 0.0, moment = 0.0;
  for (int i = -num; i <= num; ++i) {
    const double before = grey[i - kHalfPixel + kMost], after = grey[i + kHalfPixel + kMost];
    const double change = std::max(0.0, sign * (after - before));
    sum += change * change;
    moment += change * change * kStep * i;
  }
  if (!(sum > 0.0)) return {};
  return moment / sum;
}

struct Line {
  Vector2d point, direction;
};

Line LineThrough(const std::vector<Vector2d>& points) {
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Vector2d& point : points) scatter += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(scatter);
  return {mean, eigen.eigenvectors().col(1)};
}

std::optional<Vector2d> Meeting(const Line& a, const Line& b) {
  Eigen::Matrix2d M;
  M << a.direction, -b.direction;
  if (!(std::abs(M.determinant()) > 0.05)) return {};  // 3 degrees
  const Vector2d along = M.inverse() * (b.point - a.point);
  return Vector2d(a.point + along[0] * a.direction);
}

// The line of the rays through a side, from corner `from` to corner `to` (pixels).
std::optional<Line> FollowSide(const GrayImage& image,
                               const CameraModel& camera,
                               double largest_angle,
                               const Vector2d& from,
                               const Vector2d& to,
                               double sign) {
  const auto start = Unbent(camera, largest_angle, from), end = Unbent(camera, largest_angle, to);
  if (!start || !end) return {};
  const double length = (to - from).norm();
  if (length < kShortestSide) return {};
  const double reach = ReachOf(length);
  // Near its ends a side's blur is that of the next side too.
  const double margin = std::clamp(kLargestReach / length, 0.08, 0.25);
  const int num = std::clamp(static_cast<int>(length), 8, 100);
  std::vector<Vector2d> points;
  for (int i = 0; i < num; ++i) {
    const double along = margin + (1.0 - 2.0 * margin) * (i + 0.5) / num;
    const Vector2d middle = Bent(camera, *start + along * (*end - *start));
    const Vector2d next = Bent(camera, *start + (along + 0.01) * (*end - *start));
    const Vector2d across = Vector2d(middle.y() - next.y(), next.x() - middle.x()).normalized();
    const auto offset = EdgeAcross(image, middle, across, reach, sign);
    if (!offset) continue;
    const auto point = Unbent(camera, largest_angle, middle + *offset * across);
    if (point) points.push_back(*point);
  }
  if (points.size() < static_cast<std::size_t>(num + 1) / 2) return {};
  return LineThrough(points);
}

// Whether it gets brighter (1) or darker (-1) across the sides, as FollowSide() goes across them.
double SignOf(const GrayImage& image, const std::array<Vector2d, 4>& corners) {
  double sum = 0.0;
  for (int side = 0; side < 4; ++side) {
    const Vector2d from = corners[side], to = corners[(side + 1) % 4];
    const Vector2d across = Vector2d(from.y() - to.y(), to.x() - from.x()).normalized();
    const double reach = ReachOf((to - from).norm());
    for (const double along : {0.3, 0.4, 0.5, 0.6, 0.7}) {
      const Vector2d middle = from + along * (to - from);
      const auto before = GreyAt(image, middle - reach * across);
      const auto after = GreyAt(image, middle + reach * across);
      if (before && after) sum += *after - *before;
    }
  }
  return sum < 0.0 ? -1.0 : 1.0;
}

}  // namespace

std::optional<std::array<Vector2d, 4>> FollowSides(const GrayImage& image,
                                                   const CameraModel& camera,
                                                   double largest_angle,
                                                   const std::array<Vector2d, 4>& corners) {
  const double sign = SignOf(image, corners);
  std::array<Vector2d, 4> found = corners;
  for (int pass = 0; pass < kNumPasses; ++pass) {
    std::array<Line, 4> lines;
    for (int side = 0; side < 4; ++side) {
      const auto line =
          FollowSide(image, camera, largest_angle, found[side], found[(side + 1) % 4], sign);
      if (!line) return {};
      lines[side] = *line;
    }
    for (int corner = 0; corner < 4; ++corner) {
      const auto meeting = Meeting(lines[(corner + 3) % 4], lines[corner]);
      if (!meeting) return {};
      found[corner] = Bent(camera, *meeting);
      const double shortest = std::min((corners[corner] - corners[(corner + 1) % 4]).norm(),
                                       (corners[corner] - corners[(corner + 3) % 4]).norm());
      if (!((found[corner] - corners[corner]).norm() <= ReachOf(shortest))) return {};
    }
  }
  return found;
}

}  // namespace fathom
