// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// Where a marker is, from frames that show it together with markers whose place is known: a start
// for the bundle adjustment. `map` holds the known markers and this one; each frame a detection of
// it and of one known marker at least.
//
// Frames propose places: every pose that explains the known markers, with both poses of the
// marker's square. Each place is judged by how well all frames fit it, the camera's poses solved
// anew; the best few are adjusted with the poses, and the best of those is taken. So the flip of
// neither square has to be known. Few frames, spread over the record, propose and judge. Nothing if
// no place comes of it.
std::optional<Pose> PlaceMarker(const CameraModel& camera,
                                const MarkerMap& map,
                                int id,
                                std::span<const std::vector<Detection>> frames);

}  // namespace fathom
