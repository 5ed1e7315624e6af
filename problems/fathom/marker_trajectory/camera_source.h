// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

namespace fathom {

// Whether the log's source `camera` is still to be made: it holds detections, but no poses.
bool NeedsTracking(const Log& log);

// Makes Log::pose of a log that holds detections but no poses: TrackMarkers with the camera, tags
// and mount of its folder. What was lost on the way is added to the log's remarks. A log with poses
// stays as it is.
//
// Throws InputError if the calibration is missing or cannot be used, or no trajectory comes of it.
void TrackDetections(Log* log);

}  // namespace fathom
