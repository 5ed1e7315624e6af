// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/split_at_gaps.h"

#include <algorithm>

namespace fathom {

std::vector<SampleRange> SplitAtGaps(std::span<const double> time,
                                     std::span<const TimeInterval> held_out,
                                     std::size_t first,
                                     double longest_gap) {
  std::vector<SampleRange> ranges;
  for (std::size_t i = first; i < time.size(); ++i) {
    const bool is_held_out =
        std::any_of(held_out.begin(), held_out.end(), [&](const TimeInterval& interval) {
          return interval.Contains(time[i]);
        });
    const bool is_after_gap = i > first && time[i] - time[i - 1] > longest_gap;
    if (ranges.empty() || is_after_gap || ranges.back().is_held_out != is_held_out) {
      ranges.push_back({i, i, is_held_out, is_after_gap});
    }
    ranges.back().end = i + 1;
  }
  return ranges;
}

LongRanges WithoutShort(std::span<const SampleRange> ranges, std::size_t fewest) {
  LongRanges kept;
  for (const SampleRange& range : ranges) {
    if (range.size() >= fewest) {
      kept.ranges.push_back(range);
    } else {
      ++kept.num_short;
      kept.num_samples_in_short += range.size();
    }
  }
  return kept;
}

}  // namespace fathom
