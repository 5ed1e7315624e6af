// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/detection.h"
#include "fathom/geometry/pose.h"
#include "fathom/geometry/pose_increment.h"
#include "fathom/joint_refinement/problem/corner_rows.h"

#include <array>

#include <Eigen/Core>

namespace fathom {

// exp(phi + d) = exp(phi) exp(J d) for a small d: the right Jacobian of rotations.
Eigen::Matrix3d TurnJacobian(const Eigen::Vector3d& phi);

// A simulated pose, then a deviation along and about the axes of the body there:
//
//   world_from_body = simulated (exp(delta_4..6), delta_1..3)              docs/coupled.md (9)
//
// with how it moves, as a PoseIncrement, with both.
struct DeviatedPose {
  Pose world_from_body;
  Eigen::Matrix<double, 6, 6> by_simulated;  // a PoseIncrement of the simulated pose
  Eigen::Matrix<double, 6, 6> by_deviation;  // [m] and [rad], by Index(Dof)
};
DeviatedPose Deviated(const Pose& simulated, const std::array<double, 6>& deviation);

// The deviation that leads from a simulated pose to another.
std::array<double, 6> DeviationBetween(const Pose& simulated, const Pose& world_from_body);

// One detection's reprojection error at a pose, whitened, and its derivatives by a PoseIncrement;
// docs/joint_refinement.md (6).
struct PoseCornerRows {
  Eigen::Matrix<double, 8, 1> residual;
  Eigen::Matrix<double, 8, 6> by_pose;
};

// False if a corner comes to lie behind the camera. `corner_sigma` [px]
bool CornersAtPose(const CameraSetup& setup,
                   const Marker& marker,
                   const Detection& detection,
                   const Pose& world_from_body,
                   double corner_sigma,
                   PoseCornerRows* rows);

}  // namespace fathom
