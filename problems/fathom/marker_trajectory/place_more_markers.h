// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/track/pose_track.h"

#include <span>

namespace fathom {

// Gives a place to every marker that is seen together with markers that have one, from the views of
// a track. Returns whether any was placed.
bool PlaceMoreMarkers(std::span<const Detection> detections,
                      const CameraModel& camera,
                      const PoseTrack& track,
                      MarkerMap* map);

}  // namespace fathom
