// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/stamped_pose.h"
#include "fathom/track/pose_track.h"

#include <span>

namespace fathom {

// Standard deviation of the noise of a corner's u and v [px]: from what the residuals of a track
// change by from one frame to the next. What stays, of a lens or a survey that does not fit, is
// none of it, other than in MarkerTrack::corner_sigma.
//
//   sigma^2 = sum |r(i + 1) - r(i)|^2 / (s(i + 1)^2 + s(i)^2) / sum (2 per corner - 6 per pose)
//
// s: the noise scale of a frame (ViewPose::noise_scale); over frames at most a second apart that
// rest on the same markers; views[i] is what pose i of the track rests on. NaN if there are none.
double CornerNoise(const CameraModel& camera,
                   const MarkerMap& map,
                   std::span<const Detection> detections,
                   std::span<const TrackedView> views,
                   std::span<const StampedPose> track);

}  // namespace fathom
