// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/marker_trajectory/marker_track.h"

#include <span>
#include <string>

namespace fathom {

// Whether the corners of a track are further off than their noise allows.
bool IsSurveyInDoubt(const MarkerTrack& track);

// What to say of a track whose corners are further off than their noise allows: by how much, and
// which tag's place would account for it, if that of a single one does. Empty where they are not,
// or where no neighbouring frames tell the noise.
std::string RemarkOnSurveyMisfit(const CameraModel& camera,
                                 std::span<const Detection> detections,
                                 const MarkerTrack& track);

}  // namespace fathom
