// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"
#include "fathom/signal/segment.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// A part of a segment: samples `begin` to `end` - 1.
struct DiveStretch {
  std::size_t segment_index = 0;
  std::size_t begin = 0, end = 0;
};

// How long stretches are; a segment shorter than twice the shortest stays whole.
inline constexpr double kShortestStretch = 30.0;  // [s]
inline constexpr double kUsualStretch = 60.0;
inline constexpr double kLongestStretch = 120.0;

// Segments cut where little goes on: the vehicle is slow and its command steady. Of all ways to cut
// a segment into stretches of 30 to 120 s that of the least
//
//   sum over cuts of unrest + sum over stretches of ((length - 60 s) / 60 s)^2     docs/plan.md (9)
//
// Unrest is the size of the velocity, in its root mean square over the segment, and the span of the
// command, in that over the segment, both within 2 s of the cut.
std::vector<DiveStretch> CutAtNaturalEnds(std::span<const Segment> segments);

// Time, velocity and position of a stretch, with the whole command.
Segment SegmentOfStretch(const DiveStretch& stretch, std::span<const Segment> segments);

// From its first stamp to that of the next stretch; to half a sample behind its last stamp at the
// end of a segment [s].
TimeInterval TimeOf(const DiveStretch& stretch, std::span<const Segment> segments);

}  // namespace fathom
