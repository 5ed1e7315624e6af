// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"
#include "fathom/geometry/pose_increment.h"
#include "fathom/geometry/stamped_pose.h"

#include <span>
#include <vector>

namespace fathom {

// The mean error, found less true, of a camera's pose that is fitted to the corners of `tag_ids`
// by least squares, to second order in their noise (Box, Bias in nonlinear estimation, 1971):
//
//   b = -1/2 C J' h,   h = sum_k d^2 r / d l_k^2,   C = (J' J)^-1 = sum_k l_k l_k'
//
// with r(step) the residuals over the noise's standard deviation [px] and J their Jacobian. Far or
// small markers seen face on do not tell their tilt, and come out too close. Where b is no longer
// small against C, less of it comes true: its length sqrt(b' C^-1 b) = m becomes
// m / cbrt(1 + (m / 4)^3), as Monte Carlo has it; docs/marker_trajectory.md (4). The markers'
// places are taken as exact.
//
// Zero without noise, and if the corners do not determine the pose.
PoseIncrement BiasOfPose(const CameraModel& camera,
                         const MarkerMap& map,
                         std::span<const int> tag_ids,
                         const Pose& world_from_camera,
                         double corner_noise);

// Takes BiasOfPose from every pose of a track, by time; tag_ids[i] are those that pose i rests on.
//
// The bias is that of the pose smoothed over the poses within a second to either side, the position
// along a straight line: at the pose itself, the tilt that noise feigns would pass for one at which
// a marker tells more, and with few neighbours, below two frames a second, half of the bias stays.
// Neighbours whose attitude is further off than their covariances allow, as after a flip, are left
// out.
void RemoveBias(const CameraModel& camera,
                const MarkerMap& map,
                std::span<const std::vector<int>> tag_ids,
                double corner_noise,
                std::vector<StampedPose>* track);

}  // namespace fathom
