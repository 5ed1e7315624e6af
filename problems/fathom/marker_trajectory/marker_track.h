// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/marker_map.h"
#include "fathom/geometry/stamped_pose.h"
#include "fathom/log/remark.h"
#include "fathom/marker_trajectory/moved_marker.h"
#include "fathom/track/pose_track.h"

#include <limits>
#include <string>
#include <vector>

namespace fathom {

// A camera's trajectory over markers.
struct MarkerTrack {
  std::string message;  // why it ended as it did, for a person

  // One for each frame with a pose, by time, with covariances; the noise's mean error is taken out
  // to second order (RemoveBias).
  std::vector<StampedPose> world_from_camera;
  std::vector<StampedPose> world_from_body;
  // Of the corners' distances from where they are drawn, before the mean error is taken out [px].
  std::vector<double> frame_rms;

  // Standard deviation of a corner's u and v, from the residuals, and its own error [px].
  double corner_sigma = std::numeric_limits<double>::quiet_NaN();
  double corner_sigma_std = std::numeric_limits<double>::quiet_NaN();

  // The part of corner_sigma that changes from frame to frame [px] (CornerNoise()); NaN if no
  // neighbouring frames tell.
  double corner_noise = std::numeric_limits<double>::quiet_NaN();

  // The markers, with places for those estimated; what is known of these, in the order of their
  // ids: covariances as of StampedPose, about the axes of the tag.
  MarkerMap map;
  std::vector<int> estimated_ids;
  std::vector<PoseCovariance> marker_covariance;
  std::vector<int> unplaced_ids;  // seen, but never together with a marker that has a place
  std::vector<int> refuted_ids;   // seen together with one, but where no view agrees

  std::vector<MovedMarker> moved_markers;  // during the record

  // The PnP track behind it, with the account of every frame and detection.
  PoseTrack pnp;

  // What was lost, and what was decided, a sentence each; of kind kDetections or kLostMotion.
  std::vector<Remark> remarks;

  bool IsUsable() const { return !world_from_camera.empty(); }
};

}  // namespace fathom
