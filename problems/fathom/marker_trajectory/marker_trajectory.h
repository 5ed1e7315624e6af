// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"
#include "fathom/marker_trajectory/marker_track.h"
#include "fathom/track/pose_track.h"

#include <optional>
#include <span>

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
