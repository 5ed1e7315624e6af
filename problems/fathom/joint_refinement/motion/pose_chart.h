// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/geometry/pose.h"

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fathom {

// The coordinates eta in which the joint problem carries frame_from_body, with the segment's own
// frame in the world's place (segment_frame.h): x, y, z of the body [m], then roll, pitch, yaw
// [rad] of R = R_z(yaw) R_y(pitch) R_x(roll). Singular at a pitch of 90 degrees from the mean
// attitude, which no held vehicle comes near.
using PoseVector = Eigen::Matrix<double, 6, 1>;

template <typename T>
Eigen::Matrix<T, 3, 3> RotationFromAngles(const T& roll, const T& pitch, const T& yaw) {
  using std::cos;
  using std::sin;
  const T cr = cos(roll), sr = sin(roll), cp = cos(pitch), sp = sin(pitch), cy = cos(yaw),
          sy = sin(yaw);
  Eigen::Matrix<T, 3, 3> R;
  R << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,   //
      -sp, cp * sr, cp * cr;
  return R;
}

inline Pose PoseFromVector(const PoseVector& eta) {
  Pose pose;
  pose.rotation = Eigen::Quaterniond(RotationFromAngles(eta[3], eta[4], eta[5])).normalized();
  pose.translation = eta.head<3>();
  return pose;
}

// Angles in (-pi, pi].
inline PoseVector VectorFromPose(const Pose& pose) {
  const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
  PoseVector eta;
  eta << pose.translation, std::atan2(R(2, 1), R(2, 2)),
      std::asin(std::fmin(1.0, std::fmax(-1.0, -R(2, 0)))), std::atan2(R(1, 0), R(0, 0));
  return eta;
}

}  // namespace fathom
