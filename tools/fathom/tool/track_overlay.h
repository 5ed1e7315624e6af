// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/detect/detect_tags.h"
#include "fathom/images/frame_source.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/track/overlay.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// Draws the frames of a log with what a track made of them: detections in use, and in red those
// that the track rejected and the sightings that are none (`images`, where they were looked for in
// this run). `progress` is told how many frames are done, of how many.
//
// Returns what is not in the overlay, a sentence each: frames that cannot be read, where `images`
// does not tell of them, and detections at stamps that are no frame's.
std::vector<std::string> DrawOverlay(FrameSource& frames,
                                     const CameraModel& camera,
                                     const std::optional<TagDetections>& images,
                                     std::span<const Detection> detections,
                                     const MarkerTrack& track,
                                     OverlayWriter* overlay,
                                     const std::function<void(int done, int expected)>& progress);

}  // namespace fathom
