// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/marker_trajectory/marker_trajectory.h"

#include <span>
#include <string>

namespace fathom {

// By what share frame-by-frame poses from one marker understate motion along the line of sight,
// since noise tilts what is seen face on; docs/marker_trajectory.md (3) and (4).
//
//   share = 15/4 mean of s^2,   s^2 = sum of the variances of the tilt about both axes [rad^2]
//
// over the frames that rest on a single marker. From first-order covariances: right to a tenth for
// tilts known to 0.02 rad, up to half too low at 0.07 rad. 0 if no frame rests on one marker.
double LostMotionShare(std::span<const Detection> detections, const MarkerTrack& track);

// The sentence for a person, if the share is above half a percent and at least a tenth of the
// frames rest on a single marker; otherwise empty.
std::string RemarkOnLostMotion(std::span<const Detection> detections, const MarkerTrack& track);

// Whether a remark is such a sentence, whoever passes it on.
bool IsOnLostMotion(const std::string& remark);

}  // namespace fathom
