// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/segment.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// What is known of the state at the start of a stretch before any model. Scores start from
// FittedStart().

// What a segment shows at first: its initial_velocity, or where that is not known its first
// measured velocity.
double InitialVelocity(const Segment& segment);

// A straight line through samples, by least squares: its value at `start` [s], and its slope.
struct Line {
  double value = 0.0, slope = 0.0;
};
Line LineThrough(double start, std::span<const double> time, std::span<const double> value);

// The displacement along `dof` at `time` where the log has poses, in line between them; else 0.
double PositionAt(const Log& log, Dof dof, double time);

// The way from sample `first` on to each sample, along the measured velocity; 0 before it.
std::vector<double> WayAlong(std::span<const double> time,
                             std::span<const double> velocity,
                             std::size_t first);

}  // namespace fathom
