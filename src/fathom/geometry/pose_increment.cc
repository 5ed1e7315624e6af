// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/geometry/pose_increment.h"

namespace fathom {
namespace {

Eigen::Quaterniond Exp(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  if (angle < 1e-12) return Eigen::Quaterniond(1.0, 0.5 * phi.x(), 0.5 * phi.y(), 0.5 * phi.z());
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, phi / angle));
}

Eigen::Vector3d Log(const Eigen::Quaterniond& rotation) {
  const double sine = rotation.vec().norm();
  if (sine < 1e-12) return (rotation.w() < 0.0 ? -2.0 : 2.0) * rotation.vec();
  // Of the two rotation vectors the one below half a turn.
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  return 2.0 * std::atan2(sign * sine, sign * rotation.w()) / sine * rotation.vec();
}

Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& a) {
  return Eigen::Matrix3d{{0.0, -a.z(), a.y()}, {a.z(), 0.0, -a.x()}, {-a.y(), a.x(), 0.0}};
}

}  // namespace

Pose Moved(const Pose& a_from_b, const PoseIncrement& step) {
  return {(a_from_b.rotation * Exp(step.tail<3>())).normalized(),
          a_from_b.translation + step.head<3>()};
}

PoseIncrement StepBetween(const Pose& from, const Pose& to) {
  PoseIncrement step;
  step.head<3>() = to.translation - from.translation;
  step.tail<3>() = Log(from.rotation.conjugate() * to.rotation);
  return step;
}

PoseCovariance CovarianceOfComposed(const Pose& a_from_b,
                                    const PoseCovariance& covariance,
                                    const Pose& b_from_c) {
  // p_c' = p + d_p + R exp(phi) t with t the origin of c in b: its change is d_p - R [t]x phi. The
  // rotation R exp(phi) R_c = R R_c exp(R_c' phi).
  PoseCovariance slope = PoseCovariance::Identity();
  slope.topRightCorner<3, 3>() =
      -a_from_b.rotation.toRotationMatrix() * CrossMatrix(b_from_c.translation);
  slope.bottomRightCorner<3, 3>() = b_from_c.rotation.toRotationMatrix().transpose();
  return slope * covariance * slope.transpose();
}

}  // namespace fathom
