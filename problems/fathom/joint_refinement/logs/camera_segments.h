// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"
#include "fathom/joint_refinement/input.h"
#include "fathom/marker_trajectory/marker_trajectory.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace fathom {

// The frames of a track in segments, and what became of those that are in none.
struct CameraSegments {
  static constexpr std::size_t kFewestFrames = 10;  // of a segment

  std::vector<CameraSegment> segments;  // without a command
  int num_silences = 0, num_short_segments = 0;
  int num_early = 0, num_held_out = 0, num_in_short_segments = 0;  // frames
};

// Cuts the frames with a pose at a silence of over 30 s and at the held-out intervals. Frames
// before `start` [s], held-out frames and segments of fewer than 10 frames are left out and
// counted.
CameraSegments CutIntoSegments(std::span<const Detection> detections,
                               const MarkerTrack& track,
                               double start = -std::numeric_limits<double>::infinity(),
                               std::span<const TimeInterval> held_out = {});

}  // namespace fathom
