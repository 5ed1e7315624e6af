// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/coarse_segments.h"

#include "fathom/signal/filters/integral.h"

#include <algorithm>
#include <cstddef>

namespace fathom {
namespace {

constexpr std::size_t kFewestSamples = 1000;  // that are left of all segments
constexpr double kLongestStep = 0.25;         // [s], on average between what is left
constexpr std::size_t kWorthIt = 3;           // samples in one
constexpr std::size_t kFewestInSegment = 20;

double MeanOf(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  double sum = 0.0;
  for (std::size_t i = begin; i < end; ++i) sum += values[i];
  return sum / static_cast<double>(end - begin);
}

// Every `size`-th value, from the middle of the first `size` on.
std::vector<double> Thinned(const std::vector<double>& values, std::size_t size) {
  std::vector<double> thinned;
  for (std::size_t i = size / 2; i < values.size(); i += size) thinned.push_back(values[i]);
  return thinned;
}

// Groups of `size` samples become one each; what is left over at the end is left out.
Segment Coarsened(const Segment& segment, std::size_t size) {
  Segment coarse;
  for (std::size_t begin = 0; begin + size <= segment.time.size(); begin += size) {
    const std::size_t end = begin + size;
    coarse.time.push_back(MeanOf(segment.time, begin, end));
    coarse.velocity.push_back(MeanOf(segment.velocity, begin, end));
    if (!segment.position.empty()) {
      coarse.position.push_back(MeanOf(segment.position, begin, end));
    }
  }
  const std::vector<double> impulse = IntegralsOf(segment.command, coarse.time).once;
  for (std::size_t i = 0; i + 1 < coarse.time.size(); ++i) {
    coarse.command.time.push_back(coarse.time[i]);
    coarse.command.value.push_back((impulse[i + 1] - impulse[i]) /
                                   (coarse.time[i + 1] - coarse.time[i]));
  }
  coarse.initial_velocity = segment.initial_velocity;
  coarse.acceleration = Thinned(segment.acceleration, size);
  coarse.smoothed_velocity = Thinned(segment.smoothed_velocity, size);
  coarse.smoothed_force = Thinned(segment.smoothed_force, size);
  coarse.smoothed_square = Thinned(segment.smoothed_square, size);
  return coarse;
}

}  // namespace

std::vector<Segment> CoarseSegments(std::span<const Segment> segments) {
  std::size_t num_samples = 0;
  double step = 0.0;
  for (const Segment& segment : segments) {
    num_samples += segment.time.size();
    const auto num_steps = static_cast<double>(segment.time.size() - 1);
    step = std::max(step, (segment.time.back() - segment.time.front()) / num_steps);
  }
  const std::size_t size =
      std::min(num_samples / kFewestSamples, static_cast<std::size_t>(kLongestStep / step));
  if (size < kWorthIt) return {};
  std::vector<Segment> coarse;
  for (const Segment& segment : segments) {
    if (segment.time.size() < kFewestInSegment * size) return {};
    coarse.push_back(Coarsened(segment, size));
  }
  return coarse;
}

}  // namespace fathom
