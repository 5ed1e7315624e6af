// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/detection.h"
#include "fathom/marker_trajectory/marker_track.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// A surveyed marker that is set aside whenever a pose rests on certain others.
struct MarkerConflict {
  int tag_id = -1;
  std::vector<int> against;      // those others, rising
  std::vector<int> agrees_with;  // markers that a pose rests on together with it, rising
  int num_frames = 0;            // that show the conflict
};

// The conflicts of a track, by the detections that were set aside as outliers; docs/
// marker_trajectory.md, "Markers that contradict each other". "Whenever" is nearly all (80 %) of at
// least ten frames. Markers that moved (FindMovedMarkers) are left out.
std::vector<MarkerConflict> FindMarkerConflicts(std::span<const Detection> detections,
                                                const MarkerTrack& track);

// "Tag 3 contradicts tags 4, 5 whenever they are seen together ...". One sentence for all markers
// that agree with no other: the survey has them elsewhere. Both explanations for each that does.
std::vector<std::string> RemarksOn(std::span<const MarkerConflict> conflicts);

}  // namespace fathom
