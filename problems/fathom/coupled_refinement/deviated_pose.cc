// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/deviated_pose.h"

#include <cmath>

#include <Eigen/Geometry>

namespace fathom {
namespace {

Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& w) {
  Eigen::Matrix3d S;
  S << 0.0, -w[2], w[1], w[2], 0.0, -w[0], -w[1], w[0], 0.0;
  return S;
}

// How roll, pitch and yaw move with a small turn about the body's axes.
Eigen::Matrix3d AnglesByTurn(const PoseVector& eta) {
  const double cr = std::cos(eta[3]), sr = std::sin(eta[3]);
  const double cp = std::cos(eta[4]), tp = std::tan(eta[4]);
  Eigen::Matrix3d E;
  E << 1.0, sr * tp, cr * tp,  //
      0.0, cr, -sr,            //
      0.0, sr / cp, cr / cp;
  return E;
}

}  // namespace

Eigen::Matrix3d TurnJacobian(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  const Eigen::Matrix3d S = CrossMatrix(phi);
  if (angle < 1e-4) return Eigen::Matrix3d::Identity() - 0.5 * S + S * S / 6.0;
  const double square = angle * angle;
  return Eigen::Matrix3d::Identity() - (1.0 - std::cos(angle)) / square * S +
         (angle - std::sin(angle)) / (square * angle) * S * S;
}

DeviatedPose Deviated(const Pose& simulated, const std::array<double, 6>& deviation) {
  const Eigen::Vector3d shift(deviation.data()), turn(deviation.data() + 3);
  PoseIncrement own;
  own << shift, turn;
  const Pose body_from_deviated = Moved(Pose(), own);
  const Eigen::Matrix3d R = simulated.rotation.toRotationMatrix();
  DeviatedPose deviated;
  deviated.world_from_body = simulated * body_from_deviated;
  deviated.by_simulated.setZero();
  deviated.by_simulated.topLeftCorner<3, 3>().setIdentity();
  deviated.by_simulated.topRightCorner<3, 3>() = -R * CrossMatrix(shift);
  deviated.by_simulated.bottomRightCorner<3, 3>() =
      body_from_deviated.rotation.toRotationMatrix().transpose();
  deviated.by_deviation.setZero();
  deviated.by_deviation.topLeftCorner<3, 3>() = R;
  deviated.by_deviation.bottomRightCorner<3, 3>() = TurnJacobian(turn);
  return deviated;
}

std::array<double, 6> DeviationBetween(const Pose& simulated, const Pose& world_from_body) {
  const PoseIncrement step = StepBetween(Pose(), simulated.Inverse() * world_from_body);
  return {step[0], step[1], step[2], step[3], step[4], step[5]};
}

bool CornersAtPose(const CameraSetup& setup,
                   const Marker& marker,
                   const Detection& detection,
                   const Pose& world_from_body,
                   double corner_sigma,
                   PoseCornerRows* rows) {
  const PoseVector eta = VectorFromPose(world_from_body);
  CornerRows by_angles;
  if (!EvaluateCorners(setup, {}, marker, detection, eta, corner_sigma, false, &by_angles)) {
    return false;
  }
  rows->residual = by_angles.residual;
  rows->by_pose.leftCols<3>() = by_angles.by_pose.leftCols<3>();
  rows->by_pose.rightCols<3>() = by_angles.by_pose.rightCols<3>() * AnglesByTurn(eta);
  return true;
}

}  // namespace fathom
