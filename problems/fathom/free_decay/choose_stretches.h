// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"
#include "fathom/log/held_command.h"
#include "fathom/signal/segment.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fathom {

// Samples `begin` to `end` - 1 of one segment, in which nothing drives the vehicle.
struct ChosenStretch {
  std::size_t segment = 0;
  std::size_t begin = 0, end = 0;
  TimeInterval time;        // of its first and last sample [s]
  bool oscillates = false;  // its speed changes sign twice or more, beyond noise
};

// Where the command is 0, in runs of at least kFewestOfSegment samples that begin at `from` at the
// earliest.
std::vector<ChosenStretch> WhereCommandIsZero(std::span<const Segment> segments,
                                              const HeldCommand& command,
                                              std::optional<double> from);

// All samples from `from` on.
std::vector<ChosenStretch> FromThenOn(std::span<const Segment> segments, double from);

// Where the motion itself looks undriven, the longest first: the speed falls by a fifth or more
// from a peak, which is no less than a third of the greatest speed, until it rises again or the
// data end. It may swing to the other side where each swing is smaller than the one before. A
// stretch begins where the speed is below 95 % of its peak, so that no end of a drive is in it.
// docs/free_decay.md (6).
std::vector<ChosenStretch> WhereSpeedDecays(std::span<const Segment> segments);

}  // namespace fathom
