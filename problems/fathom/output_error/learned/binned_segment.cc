// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/binned_segment.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cstddef>

namespace fathom {

double BinWidth(std::span<const Segment> segments) {
  constexpr double kNumBins = 2000.0, kLongest = 0.5;
  double duration = 0.0;
  for (const Segment& segment : segments) duration += segment.time.back() - segment.time.front();
  return std::min(duration / kNumBins, kLongest);
}

BinnedSegment BinnedSegmentOf(const Segment& segment,
                              FittedOutput output,
                              double width,
                              const std::vector<bool>& is_wild) {
  constexpr double kRounding = 1e-6;  // of stamps [s]
  const NoiseChannel channel =
      output == FittedOutput::kVelocity ? NoiseChannel::kVelocity : NoiseChannel::kDisplacement;
  const std::vector<double>& time = segment.time;
  BinnedSegment bins;
  bins.segment = &segment;
  bins.output = output;
  bins.width = width;
  bins.bin_of.assign(time.size(), -1);
  for (std::size_t begin = 0; begin < time.size();) {
    double sum = 0.0, count = 0.0;
    std::size_t end = begin;
    for (; end == begin || (end < time.size() && time[end] - time[begin] < width - kRounding);
         ++end) {
      if (is_wild[end]) continue;
      bins.bin_of[end] = bins.size();
      sum += time[end];
      count += 1.0;
    }
    begin = end;
    if (count == 0.0) continue;
    bins.count.push_back(count);
    bins.samples.push_back({.time = sum / count, .channel = channel});
  }
  if (bins.count.empty()) return bins;
  const double usual = Median(bins.count);
  for (std::size_t i = 0; i < bins.samples.size(); ++i) {
    bins.samples[i].variance_factor = usual / bins.count[i];
  }
  return bins;
}

}  // namespace fathom
