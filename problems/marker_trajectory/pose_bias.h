// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vision/camera_model.h"
#include "fathom/vision/detection.h"
#include "fathom/vision/marker_map.h"
#include "fathom/vision/pose.h"
#include "fathom/vision/pose_increment.h"
#include "fathom/vision/stamped_pose.h"

#include <span>
#include <vector>

namespace fathom {

// The mean error, found less true, of a camera's pose that is fitted to the corners of `tag_ids`
// by least squares, to second order in their noise (Box, Bias in nonlinear estimation, 1971):
//
//   b = -1/2 C J' sum_k (r(l_k) + r(-l_k) - 2 r(0)),   C = (J' J)^-1 = sum_k l_k l_k'
//
// with r(step) the residuals over corner_sigma and J their Jacobian. Far or small markers seen face
// on do not tell their tilt, and come out too close. Where b is no longer small against C, less of
// it comes true: its length sqrt(b' C^-1 b) = m becomes m / cbrt(1 + (m / 4)^3), as Monte Carlo has
// it; docs/marker_trajectory.md (4).
//
// Zero without noise, if the corners do not determine the pose, and where the noise puts one behind
// the camera.
PoseIncrement BiasOfPose(const CameraModel& camera,
                         const MarkerMap& map,
                         std::span<const int> tag_ids,
                         const Pose& world_from_camera,
                         double corner_sigma);

// Takes BiasOfPose from every pose of a track, by time; tag_ids[i] are those that pose i rests on.
// The bias is that of the mean of the poses within a second to either side: at the pose itself, the
// tilt that noise feigns would pass for one at which a marker tells more.
void RemoveBias(const CameraModel& camera,
                const MarkerMap& map,
                std::span<const std::vector<int>> tag_ids,
                double corner_sigma,
                std::vector<StampedPose>* track);

}  // namespace fathom
