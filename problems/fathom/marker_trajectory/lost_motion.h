// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/marker_trajectory/marker_track.h"

#include <span>
#include <string>

namespace fathom {

// The poses from a single marker that do not know its tilt: noise tilts what is seen face on, and
// of the motion along the line of sight a share is lost, also where the mean error has been taken
// out (RemoveBias); docs/marker_trajectory.md (5).
struct LostMotion {
  int num_poses = 0;           // that rest on a single marker and may lose more than 0.2 %
  double tilt_variance = 0.0;  // of both axes together, the mean over these poses [rad^2]
  double share = 0.0;          // of the motion, about what may be lost: 1.5 tilt_variance
};

LostMotion LostMotionOf(std::span<const Detection> detections, const MarkerTrack& track);

// The sentence for a person, if at least a tenth of the poses are such; otherwise empty.
std::string RemarkOnLostMotion(std::span<const Detection> detections, const MarkerTrack& track);

}  // namespace fathom
