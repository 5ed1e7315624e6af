// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"
#include "fathom/geometry/pose_increment.h"

#include <array>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace fathom {

// A point of the world [m] and where it was seen [px].
struct SeenCorner {
  Eigen::Vector3d x_world;
  Eigen::Vector2d pixel;
};

// The corners of a marker in the order of its detection.
std::array<SeenCorner, 4> SeenCornersOf(const Marker& marker, const Detection& detection);

// Squared residuals of the corners, summed [px^2]; infinite if one is behind the camera.
double SquaredError(const CameraModel& camera,
                    std::span<const SeenCorner> corners,
                    const Pose& world_from_camera);

struct RefinedPose {
  Pose world_from_camera;

  // (J'J)^-1: the pose's covariance for a corner sigma of 1 px. [m^2/px^2], [rad^2/px^2].
  PoseCovariance unit_covariance;
};

// The minimum of the reprojection error of the corners next to `start`. Residuals of a corner
// beyond `huber` [px] count linearly. None if the search fails or the corners leave the pose open.
std::optional<RefinedPose> RefinePose(const CameraModel& camera,
                                      std::span<const SeenCorner> corners,
                                      const Pose& start,
                                      double huber);

}  // namespace fathom
