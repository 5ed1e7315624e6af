// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/mean_attitude.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kShortest = 0.1;   // of a mean axis that tells a direction; 1 if it never turns
constexpr double kAligned = 0.005;  // [rad]

// The body's axis `i` in the world.
Eigen::Vector3d MiddleAxis(int i, std::span<const Eigen::Quaterniond> world_from_body) {
  Eigen::Vector3d middle;
  for (int row = 0; row < 3; ++row) {
    std::vector<double> values;
    for (const auto& rotation : world_from_body) {
      values.push_back((rotation * Eigen::Vector3d::Unit(i))[row]);
    }
    middle[row] = Median(std::move(values));
  }
  return middle;
}

// The world's axis that one as near as kAligned is taken for.
Eigen::Vector3d Aligned(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d nearest = axis.array().round();
  return (axis - nearest).norm() < kAligned ? nearest : axis;
}

}  // namespace

Eigen::Quaterniond MeanAttitude(Dof dof, std::span<const Eigen::Quaterniond> world_from_body) {
  CHECK(!world_from_body.empty());
  const Eigen::Matrix3d first = world_from_body.front().toRotationMatrix();
  const int i = Index(dof) % 3, j = (i + 1) % 3, k = (i + 2) % 3;
  Eigen::Vector3d along = MiddleAxis(i, world_from_body);
  if (along.norm() < kShortest) along = first.col(i);
  along = Aligned(along.normalized());
  const auto across = [&](const Eigen::Vector3d& axis) {
    return Eigen::Vector3d(axis - along * along.dot(axis));
  };
  Eigen::Vector3d second = across(MiddleAxis(j, world_from_body));
  if (second.norm() < kShortest) second = across(first.col(j));
  // A first body axis that happens to lie along the mean one.
  if (second.norm() < kShortest) second = across(first.col(i));
  second = across(Aligned(second.normalized())).normalized();
  Eigen::Matrix3d mean;
  mean.col(i) = along;
  mean.col(j) = second;
  mean.col(k) = along.cross(second);
  return Eigen::Quaterniond(mean).normalized();
}

double AxisTurn(Dof dof, std::span<const Eigen::Quaterniond> world_from_body) {
  const int i = Index(dof) % 3;
  const Eigen::Vector3d mean = MeanAttitude(dof, world_from_body) * Eigen::Vector3d::Unit(i);
  double sum = 0.0;
  for (const auto& rotation : world_from_body) {
    sum += 2.0 * (1.0 - (rotation * Eigen::Vector3d::Unit(i)).dot(mean));
  }
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(world_from_body.size()));
}

}  // namespace fathom
