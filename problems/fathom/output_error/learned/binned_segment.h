// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"
#include "fathom/output_error/shooting_window.h"
#include "fathom/signal/segment.h"

#include <span>
#include <vector>

namespace fathom {

// The samples of one segment averaged over short bins, a row each, so that what is learned of them
// costs little. Wild samples are in no bin.
struct BinnedSegment {
  const Segment* segment = nullptr;  // must outlive this
  FittedOutput output = FittedOutput::kVelocity;
  double width = 0.0;                // at most [s]
  std::vector<int> bin_of;           // by sample; -1: in none
  std::vector<double> count;         // of samples, by bin
  std::vector<NoiseSample> samples;  // by bin: its mean time, its noise; of segment 0

  int size() const { return static_cast<int>(samples.size()); }
};

// How long a bin is [s]: about two thousand to the whole of the segments, half a second at most.
// (A mean over less than the samples' own step is the sample.)
double BinWidth(std::span<const Segment> segments);

// `is_wild` by sample.
BinnedSegment BinnedSegmentOf(const Segment& segment,
                              FittedOutput output,
                              double width,
                              const std::vector<bool>& is_wild);

}  // namespace fathom
