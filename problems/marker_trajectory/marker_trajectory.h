// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vision/camera_model.h"
#include "fathom/vision/detection.h"
#include "fathom/vision/marker_map.h"
#include "fathom/vision/pose.h"
#include "fathom/vision/pose_track.h"
#include "fathom/vision/stamped_pose.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

struct MarkerTrajectoryOptions {
  // PnP frame by frame, which the bundle adjustment starts from; holds the stamps of all frames.
  PoseTrackOptions pose_track;

  // True: the survey of the markers is only a start; all but one are estimated with the poses.
  // False: only those without a place.
  bool estimate_surveyed_markers = false;

  // The surveyed marker that then stays where it is; the one seen most often if not given.
  std::optional<int> reference_id;
};

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

  // The PnP track behind it, with the account of every frame and detection.
  PoseTrack pnp;

  // What was lost, and what was decided, a sentence each.
  std::vector<std::string> remarks;

  bool IsUsable() const { return !world_from_camera.empty(); }
};

// The vehicle's trajectory from a camera's detections: PnP, flips resolved over time, then a bundle
// adjustment of all poses and of the markers whose place is not known; docs/marker_trajectory.md.
//
// Throws InputError for detections that cannot be used (ScreenDetections), and for a reference_id
// that is no surveyed marker.
MarkerTrack TrackMarkers(std::span<const Detection> detections,
                         const CameraModel& camera,
                         const MarkerMap& map,
                         const Pose& body_from_camera,
                         const MarkerTrajectoryOptions& options = {});

}  // namespace fathom
