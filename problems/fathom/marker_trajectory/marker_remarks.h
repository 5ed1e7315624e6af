// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/log/remark.h"
#include "fathom/marker_trajectory/marker_track.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// What must be known of a track's poses beside their standard deviations: what was lost on the way,
// what was decided, and what makes them worse than they look. `reference`: the surveyed marker that
// holds the world where the others are estimated.
std::vector<Remark> RemarksOn(const MarkerTrack& track,
                              const std::optional<int>& reference,
                              std::span<const Detection> detections,
                              const CameraModel& camera);

}  // namespace fathom
