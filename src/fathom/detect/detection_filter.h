// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/detect/tag_detector.h"

#include <span>
#include <string_view>
#include <vector>

namespace fathom {

// Why a sighting is not used.
enum class SightingFault {
  kWrongBits,    // more bits of its code were wrong than allowed
  kNotInMap,     // the map has no marker of this family and id
  kSeveralSeen,  // the same marker stands in the frame more than once: which is it?
  kDegenerate,   // its corners are no convex quadrangle in the order of AprilTag 3
};

// "has wrong bits in its code", ...
std::string_view Describe(SightingFault fault);

struct UnusedSighting {
  double time = 0.0;  // of the frame [s]
  TagSighting sighting;
  SightingFault fault = SightingFault::kWrongBits;
};

// The sightings of one frame that are detections of the map's markers, and the others with the
// reason.
struct FrameDetections {
  std::vector<Detection> detections;  // by rising id
  std::vector<UnusedSighting> unused;
};

FrameDetections DetectionsAmong(std::span<const TagSighting> sightings,
                                const MarkerMap& map,
                                int max_hamming,
                                double time);

}  // namespace fathom
