// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/stamp_noise.h"
#include "fathom/signal/segment.h"
#include "fathom/signal/split_at_gaps.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What a fit is made to, and how far from it the model stays.
struct RunNoise {
  bool is_position = false;  // displacements, where there are poses; else velocities
  StampNoise noise;          // `velocity`: of one sample of that output, [m/s], [rad/s], [m], [rad]

  // Of neighbouring samples; 0: white.
  double NeighbourCorrelation() const;
};

// A segment beside the model's run over it.
struct ComparedSegment {
  const Segment* segment;
  std::span<const double> simulated;  // velocities or displacements
  const Eigen::MatrixXd* by_start;    // derivatives of these
};

// Without a missing sample inside: the colour counts samples, not seconds. Of at least two stamps.
std::vector<SampleRange> UnbrokenRanges(std::span<const double> time);

// Size and colour of what the runs of a model miss, less what another start would take up: as
// docs/output_error.md (5) has it, residuals beyond three robust standard deviations cut off there.
// Runs are all of velocities or all of displacements.
RunNoise NoiseOfRuns(std::span<const ComparedSegment> runs, bool is_position);

}  // namespace fathom
