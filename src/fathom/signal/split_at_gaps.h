// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// A longer silence of a stream cuts its data [s]; a shorter one is integrated across.
inline constexpr double kLongestGap = 30.0;

// Samples `begin` to `end` - 1 of a stream: no gap lies between them, and all of them or none are
// held out.
struct SampleRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool is_held_out = false;
  bool is_after_gap = false;  // between it and the range before

  std::size_t size() const { return end - begin; }
};

// Cuts a stream with the stamps `time` [s], rising, at every silence of over `longest_gap` [s] and
// at the ends of the intervals `held_out`. Each sample from `first` on is in one range; the ranges
// stand in the order of time.
std::vector<SampleRange> SplitAtGaps(std::span<const double> time,
                                     std::span<const TimeInterval> held_out = {},
                                     std::size_t first = 0,
                                     double longest_gap = kLongestGap);

// The ranges of at least `fewest` samples, and how many are shorter.
struct LongRanges {
  std::vector<SampleRange> ranges;
  std::size_t num_short = 0;
  std::size_t num_samples_in_short = 0;
};
LongRanges WithoutShort(std::span<const SampleRange> ranges, std::size_t fewest);

}  // namespace fathom
