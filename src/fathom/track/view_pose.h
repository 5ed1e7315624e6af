// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"
#include "fathom/geometry/pose_increment.h"

#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The two poses from which a single square is seen almost alike, each refined; docs/vision.md (5).
// Both are local minima of the reprojection error, the better one first; a single one where both
// run into the same. None if the corners are no view of a square (not convex, or outside the lens'
// field).
std::vector<Pose> SolveSquare(const CameraModel& camera,
                              double size,
                              const std::array<Eigen::Vector2d, 4>& corners);

// A pose of the camera that explains one frame.
struct ViewPose {
  Pose world_from_camera;

  // Which of the frame's detections it explains; the others are further off than the gate.
  std::vector<int> used;  // indices into the frame, rising

  // Of the used corners: sum of squared residuals [px^2], and 2 per corner less the pose's 6.
  double squared_error = 0.0;
  int degrees_of_freedom = 0;

  // The noise of this frame's corners over that of most frames, at least 1. More than 1 only where
  // several detections agree on the pose, and so much noise has a chance below one in a thousand:
  // of a fast turn, for instance.
  double noise_scale = 1.0;

  // (J'J)^-1: the pose's covariance for a corner sigma of 1 px. [m^2/px^2], [rad^2/px^2].
  PoseCovariance unit_covariance = PoseCovariance::Zero();
};

struct ViewPoseOptions {
  // A detection whose corners are on average (rms) further off than this is not of this pose [px].
  // Where most of at least four detections agree, their own noise sets the gate: docs/vision.md.
  double gate = 20.0;

  // Standard deviation of a corner's u and v in most frames [px]; 0: not known yet.
  double corner_sigma = 0.0;

  // Residuals of a corner beyond this count linearly (Huber) [px]; infinity: never.
  double huber = std::numeric_limits<double>::infinity();
};

// The poses that explain a frame, the best first: most detections, then the least error. Candidates
// are the two poses of each square; of these, the four that fit all of the frame's corners best are
// refined, each over the corners of the detections that it explains. Where that are no more than
// half, a wild one among them may have spoilt the fit: the set is then grown from the candidate's
// own square, one detection at a time that one pose explains together with those before. Of five or
// more, some may agree on something wrong: fewer than half do not spoil the pose. Poses that
// end in the same minimum are one. Every detection's marker must be in the map and have a place.
std::vector<ViewPose> SolveView(const CameraModel& camera,
                                const MarkerMap& map,
                                std::span<const Detection> frame,
                                const ViewPoseOptions& options = {});

// The same with the squares solved before: squares[i] is SolveSquare() of the i-th detection.
std::vector<ViewPose> SolveView(const CameraModel& camera,
                                const MarkerMap& map,
                                std::span<const Detection> frame,
                                std::span<const std::vector<Pose>> squares,
                                const ViewPoseOptions& options = {});

}  // namespace fathom
