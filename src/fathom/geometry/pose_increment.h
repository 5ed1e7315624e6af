// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/geometry/pose.h"

#include <cmath>

#include <Eigen/Core>

namespace fathom {

// A small step away from a pose a_from_b, in the order of every covariance of a pose:
//
//   d = (d_p, phi)     p' = p + d_p,   R' = R exp(phi)        docs/vision.md (4)
//
//   d_p  in the axes of a [m]
//   phi  rotation vector about the axes of b [rad], below half a turn
using PoseIncrement = Eigen::Vector<double, 6>;
using PoseCovariance = Eigen::Matrix<double, 6, 6>;

// exp(phi) x, by Rodrigues' formula, for double and ceres::Jet alike.
template <typename T>
Eigen::Matrix<T, 3, 1> Rotate(const Eigen::Matrix<T, 3, 1>& phi, const Eigen::Matrix<T, 3, 1>& x) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Eigen::Matrix<T, 3, 1> phi_x = phi.cross(x);
  const T square = phi.squaredNorm();
  if (square < 1e-12) {  // exact to 1e-18 of x, and its derivative to 1e-12
    return x + phi_x + 0.5 * phi.cross(phi_x);
  }
  const T angle = sqrt(square);
  const T a = sin(angle) / angle;
  const T b = (1.0 - cos(angle)) / square;
  return x + a * phi_x + b * phi.cross(phi_x);
}

// x_a of a point x_b, for the pose that is a step d away from a_from_b.
template <typename T>
Eigen::Matrix<T, 3, 1> TransformNear(const Pose& a_from_b,
                                     const T* d,
                                     const Eigen::Matrix<T, 3, 1>& x_b) {
  const Eigen::Matrix<T, 3, 1> phi(d[3], d[4], d[5]);
  const Eigen::Matrix3d rotation = a_from_b.rotation.toRotationMatrix();
  const Eigen::Matrix<T, 3, 1> rotated = rotation.template cast<T>() * Rotate(phi, x_b);
  return {rotated[0] + a_from_b.translation[0] + d[0],
          rotated[1] + a_from_b.translation[1] + d[1],
          rotated[2] + a_from_b.translation[2] + d[2]};
}

// x_b of a point x_a, for the pose that is a step d away from a_from_b.
template <typename T>
Eigen::Matrix<T, 3, 1> InverseTransformNear(const Pose& a_from_b,
                                            const T* d,
                                            const Eigen::Matrix<T, 3, 1>& x_a) {
  const Eigen::Matrix3d transposed = a_from_b.rotation.toRotationMatrix().transpose();
  const Eigen::Matrix<T, 3, 1> from_origin(x_a[0] - a_from_b.translation[0] - d[0],
                                           x_a[1] - a_from_b.translation[1] - d[1],
                                           x_a[2] - a_from_b.translation[2] - d[2]);
  const Eigen::Matrix<T, 3, 1> minus_phi(-d[3], -d[4], -d[5]);
  const Eigen::Matrix<T, 3, 1> turned = transposed.template cast<T>() * from_origin;
  return Rotate(minus_phi, turned);
}

// The pose a step away.
Pose Moved(const Pose& a_from_b, const PoseIncrement& step);

// The step from one pose to another: Moved(from, StepBetween(from, to)) is `to`.
PoseIncrement StepBetween(const Pose& from, const Pose& to);

// The covariance of a_from_c = a_from_b b_from_c, where b_from_c is exact, from that of a_from_b.
PoseCovariance CovarianceOfComposed(const Pose& a_from_b,
                                    const PoseCovariance& covariance,
                                    const Pose& b_from_c);

}  // namespace fathom
