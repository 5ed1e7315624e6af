// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/motion/pose_chart.h"
#include "fathom/joint_refinement/motion/predicted_motion.h"
#include "fathom/joint_refinement/problem/linear_joint.h"

#include <functional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fathom {

// Covariance of each refined pose of a segment, everything else unknown as well: of (translation,
// rotation vector about the axes of the moving frame), [m] and [rad], as in StampedPose. The pose
// is mean plus deviation, and both follow from the globals:
//
//   eta_k = mean_k(g) + d_k(g),   d_k(g) ~ N(. + G_k g, P_k)
//   cov eta_k = (D_k + G_k) cov(g) (D_k + G_k)' + P_k          docs/joint_refinement.md (13)
//
// The translation is turned into the world by `world_from_frame`, the attitude of the segment's
// frame. `joint` is linearised at the present unknowns of `motion`; `eta_of(k)` is the refined
// pose.
std::vector<Eigen::Matrix<double, 6, 6>> PoseSpread(
    const LinearJoint& joint,
    size_t segment,
    const PredictedMotion& motion,
    const Eigen::Quaterniond& world_from_frame,
    const std::function<PoseVector(size_t)>& eta_of);

}  // namespace fathom
