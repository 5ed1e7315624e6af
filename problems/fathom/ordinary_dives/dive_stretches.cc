// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/dive_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fathom {
namespace {

constexpr double kAboutCut = 2.0;           // [s], either way
constexpr double kCutStep = 1.0;            // between moments that are looked at [s]
constexpr std::size_t kFewestSamples = 10;  // of a stretch

double SpanOf(std::span<const double> values) {
  if (values.empty()) return 0.0;
  const auto [low, high] = std::ranges::minmax_element(values);
  return *high - *low;
}

// A moment at which a segment may be cut.
struct CutMoment {
  std::size_t sample = 0;
  double time = 0.0;
  double unrest = 0.0;
};

// The first and the last sample's moments cost nothing: a segment ends there anyway.
std::vector<CutMoment> MomentsOf(const Segment& segment) {
  const std::vector<double>& time = segment.time;
  const std::vector<double> force = segment.command.At(time);
  double squares = 0.0;
  for (const double v : segment.velocity) squares += v * v;
  constexpr double kNothing = std::numeric_limits<double>::min();
  const double usual_speed =
      std::max(kNothing, std::sqrt(squares / static_cast<double>(time.size())));
  const double usual_span = std::max(kNothing, SpanOf(force));
  std::vector<CutMoment> moments = {{0, time.front(), 0.0}};
  for (std::size_t i = 1; i + 1 < time.size(); ++i) {
    if (time[i] < moments.back().time + kCutStep) continue;
    const auto from = std::ranges::lower_bound(time, time[i] - kAboutCut) - time.begin();
    const auto to = std::ranges::upper_bound(time, time[i] + kAboutCut) - time.begin();
    double speed = 0.0;
    for (auto k = from; k < to; ++k) {
      speed = std::max(speed, std::abs(segment.velocity[static_cast<std::size_t>(k)]));
    }
    const double span = SpanOf({force.begin() + from, force.begin() + to});
    moments.push_back({i, time[i], speed / usual_speed + span / usual_span});
  }
  moments.push_back({time.size(), time.back(), 0.0});
  return moments;
}

double LengthCost(double length) {
  const double miss = (length - kUsualStretch) / kUsualStretch;
  return miss * miss;
}

// The cheapest way to each moment, from that before it.
std::vector<std::size_t> CheapestCuts(const std::vector<CutMoment>& moments) {
  std::vector<double> cost(moments.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(moments.size(), 0);
  cost.front() = 0.0;
  for (std::size_t k = 1; k < moments.size(); ++k) {
    for (std::size_t i = k; i-- > 0;) {
      const double length = moments[k].time - moments[i].time;
      if (length > kLongestStretch) break;
      if (length < kShortestStretch) continue;
      if (moments[k].sample - moments[i].sample < kFewestSamples) continue;
      const double through = cost[i] + LengthCost(length) + moments[k].unrest;
      if (through >= cost[k]) continue;
      cost[k] = through;
      before[k] = i;
    }
  }
  if (std::isinf(cost.back())) return {0, moments.size() - 1};
  std::vector<std::size_t> ends = {moments.size() - 1};
  while (ends.back() != 0) ends.push_back(before[ends.back()]);
  std::ranges::reverse(ends);
  return ends;
}

}  // namespace

std::vector<DiveStretch> CutAtNaturalEnds(std::span<const Segment> segments) {
  std::vector<DiveStretch> stretches;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::vector<CutMoment> moments = MomentsOf(segments[s]);
    const std::vector<std::size_t> ends = CheapestCuts(moments);
    for (std::size_t k = 1; k < ends.size(); ++k) {
      stretches.push_back({s, moments[ends[k - 1]].sample, moments[ends[k]].sample});
    }
  }
  return stretches;
}

Segment SegmentOfStretch(const DiveStretch& stretch, std::span<const Segment> segments) {
  const Segment& whole = segments[stretch.segment_index];
  const auto part = [&](const std::vector<double>& values) {
    if (values.empty()) return values;
    return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(stretch.begin),
                               values.begin() + static_cast<std::ptrdiff_t>(stretch.end));
  };
  Segment segment;
  segment.time = part(whole.time);
  segment.velocity = part(whole.velocity);
  segment.position = part(whole.position);
  segment.command = whole.command;
  return segment;
}

TimeInterval TimeOf(const DiveStretch& stretch, std::span<const Segment> segments) {
  const std::vector<double>& time = segments[stretch.segment_index].time;
  if (stretch.end < time.size()) return {time[stretch.begin], time[stretch.end]};
  const double last = time[stretch.end - 1];
  const double step = last - time[stretch.end - 2];
  return {time[stretch.begin], last + 0.5 * step};
}

}  // namespace fathom
