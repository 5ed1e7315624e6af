// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fathom {

// A rigid transform, named by what it maps: world_from_body turns the coordinates of a point in the
// body frame into those in the world frame (docs/notation.md). Neighbours cancel when composed:
//
//   const Pose world_from_camera = world_from_body * body_from_camera;
//   const Eigen::Vector3d x_world = world_from_camera * x_camera;
//
// As a pose: the translation is the origin of the second frame in the first, the rotation its
// attitude.
struct Pose {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // length 1
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         // [m]

  Pose Inverse() const {
    const Eigen::Quaterniond inverse = rotation.conjugate();
    return {inverse, -(inverse * translation)};
  }
};

inline Eigen::Vector3d operator*(const Pose& a_from_b, const Eigen::Vector3d& x_b) {
  return a_from_b.rotation * x_b + a_from_b.translation;
}

inline Pose operator*(const Pose& a_from_b, const Pose& b_from_c) {
  return {(a_from_b.rotation * b_from_c.rotation).normalized(), a_from_b * b_from_c.translation};
}

}  // namespace fathom
