// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"
#include "fathom/joint_refinement/motion/pose_chart.h"

#include <array>

#include <Eigen/Core>

namespace fathom {

// How a camera hangs on a vehicle; with `size_scale` on the sides of the markers that it sees and
// `mount` a small move of it (translation [m] in the body frame, rotation vector [rad], right to
// its second order, in the camera's).
struct CameraSetup {
  CameraModel camera;
  Pose body_from_camera;
};

struct SetupUnknowns {
  double size_scale = 1.0;
  std::array<double, 6> mount = {};
};

// One detection's reprojection error at a pose of the frame that the marker is in, and its
// derivatives; docs/joint_refinement.md (6).
//
//   r = (Project(camera_from_world x_world) - detected) / sigma    8 rows: u, v of the four corners
struct CornerRows {
  Eigen::Matrix<double, 8, 1> residual;
  Eigen::Matrix<double, 8, 6> by_pose;   // eta
  Eigen::Matrix<double, 8, 7> by_setup;  // size scale, mount
};

// False if a corner comes to lie behind the camera. `corner_sigma` [px]; by_setup is filled only if
// `with_setup`.
bool EvaluateCorners(const CameraSetup& setup,
                     const SetupUnknowns& unknowns,
                     const Marker& marker,
                     const Detection& detection,
                     const PoseVector& eta,
                     double corner_sigma,
                     bool with_setup,
                     CornerRows* rows);

// The residual alone, in a fraction of the time.
bool EvaluateResidual(const CameraSetup& setup,
                      const SetupUnknowns& unknowns,
                      const Marker& marker,
                      const Detection& detection,
                      const PoseVector& eta,
                      double corner_sigma,
                      Eigen::Matrix<double, 8, 1>* residual);

}  // namespace fathom
