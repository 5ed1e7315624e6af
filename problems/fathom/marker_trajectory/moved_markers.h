// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/marker_trajectory/marker_track.h"
#include "fathom/marker_trajectory/moved_marker.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// The markers of a track that moved during the record, by the detections that were set aside as
// outliers; docs/marker_trajectory.md, "A marker that moved". Of each marker's detections in frames
// whose pose rests on others too: from some time on nearly all are set aside, before it few are,
// and one other place explains those after it. Those after it count only in frames whose pose rests
// on a marker that this one agreed with before: others may be wrong themselves. It must stay moved
// to the end. Markers that were placed by the track itself are left out.
//
// It needs another marker in the same frames. A move by less than the gate of the outliers (four
// corner sigmas) is none.
std::vector<MovedMarker> FindMovedMarkers(const CameraModel& camera,
                                          std::span<const Detection> detections,
                                          const MarkerTrack& track);

// "Tag 4 sits 8.6 cm elsewhere from t = 171 s on ..."
std::string RemarkOn(const MovedMarker& moved);

}  // namespace fathom
