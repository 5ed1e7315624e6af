// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/clipped_area.h"

#include <cmath>

namespace fathom {
namespace {

// A convex polygon; four corners and one more for each side of the rectangle at most.
struct Polygon {
  std::array<Eigen::Vector2d, 8> corners;
  int size = 0;

  void Add(const Eigen::Vector2d& corner) { corners[size++] = corner; }

  // By the shoelace formula, from the first corner on, which keeps small areas exact.
  double Area() const {
    double twice = 0.0;
    for (int i = 1; i + 1 < size; ++i) {
      const Eigen::Vector2d a = corners[i] - corners[0];
      const Eigen::Vector2d b = corners[i + 1] - corners[0];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * std::abs(twice);
  }
};

// The part where sign * (coordinate - limit) <= 0 (Sutherland and Hodgman).
Polygon Cut(const Polygon& polygon, int axis, double limit, double sign) {
  Polygon cut;
  for (int i = 0; i < polygon.size; ++i) {
    const Eigen::Vector2d& a = polygon.corners[i];
    const Eigen::Vector2d& b = polygon.corners[(i + 1) % polygon.size];
    const double beyond_a = sign * (a[axis] - limit);
    const double beyond_b = sign * (b[axis] - limit);
    if (beyond_a <= 0.0) cut.Add(a);
    if ((beyond_a < 0.0 && beyond_b > 0.0) || (beyond_a > 0.0 && beyond_b < 0.0)) {
      cut.Add(a + beyond_a / (beyond_a - beyond_b) * (b - a));
    }
  }
  return cut;
}

Polygon PolygonOf(const std::array<Eigen::Vector2d, 4>& quadrangle) {
  Polygon polygon;
  for (const Eigen::Vector2d& corner : quadrangle) polygon.Add(corner);
  return polygon;
}

}  // namespace

double AreaOf(const std::array<Eigen::Vector2d, 4>& quadrangle) {
  return PolygonOf(quadrangle).Area();
}

double AreaWithin(const std::array<Eigen::Vector2d, 4>& quadrangle,
                  const Eigen::Vector2d& low,
                  const Eigen::Vector2d& high) {
  Polygon polygon = PolygonOf(quadrangle);
  for (int axis = 0; axis < 2; ++axis) {
    polygon = Cut(polygon, axis, low[axis], -1.0);
    polygon = Cut(polygon, axis, high[axis], 1.0);
  }
  return polygon.Area();
}

}  // namespace fathom
