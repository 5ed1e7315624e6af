// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/part_of_segment.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace fathom {
namespace {

// The samples of a segment within [from, to].
MeasuredSegment Between(const MeasuredSegment& segment, double from, double to) {
  MeasuredSegment part = segment;
  const auto cut = [&](std::vector<double>* time,
                       std::initializer_list<std::vector<double>*> values) {
    const auto begin = std::lower_bound(time->begin(), time->end(), from) - time->begin();
    const auto end = std::upper_bound(time->begin(), time->end(), to) - time->begin();
    for (std::vector<double>* value : values) {
      if (!value->empty()) *value = {value->begin() + begin, value->begin() + end};
    }
    *time = {time->begin() + begin, time->begin() + end};
  };
  cut(&part.stamps.velocity, {&part.velocity});
  cut(&part.stamps.displacement, {&part.displacement, &part.displacement_variance});
  return part;
}

// Where nothing measures the position: along the measured velocity, as MeasuredSegmentsOf() counts
// it.
double PositionAt(const MeasuredSegment& segment, double time) {
  double position = segment.initial.position;
  const std::vector<double>& t = segment.stamps.velocity;
  for (size_t i = 1; i < t.size() && t[i] <= time; ++i) {
    position += 0.5 * (t[i] - t[i - 1]) * (segment.velocity[i - 1] + segment.velocity[i]);
  }
  return position;
}

}  // namespace

std::optional<MeasuredSegment> PartOf(const MeasuredSegment& segment,
                                      double from,
                                      double to,
                                      size_t least) {
  MeasuredSegment part = Between(segment, from, to);
  const auto& time = part.velocity.empty() ? part.stamps.displacement : part.stamps.velocity;
  if (time.size() < least) return std::nullopt;
  if (part.displacement.empty()) part.initial.position = PositionAt(segment, time.front());
  RestartAt(time.front(), &part);
  return part;
}

}  // namespace fathom
