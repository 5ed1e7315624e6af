// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/excerpt.h"

#include "fathom/diagnosis/data/part_of_segment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr double kPiece = 300.0;  // [s], about

// A share of one segment.
void AddPieces(const MeasuredSegment& segment, double share, std::vector<MeasuredSegment>* pieces) {
  const double kept = share * segment.duration();
  const double count = std::max(1.0, std::round(kept / kPiece));
  const double length = kept / count, spacing = segment.duration() / count;
  for (double k = 0.0; k < count; k += 1.0) {
    const double from = segment.stamps.start + (k + 0.5) * spacing - 0.5 * length;
    if (auto piece = PartOf(segment, from, from + length)) pieces->push_back(*std::move(piece));
  }
}

}  // namespace

std::vector<MeasuredSegment> Excerpt(std::vector<MeasuredSegment> segments, double most) {
  const double duration = DurationOf(segments);
  if (!(duration > most)) return segments;
  std::vector<MeasuredSegment> pieces;
  for (const MeasuredSegment& segment : segments) AddPieces(segment, most / duration, &pieces);
  return pieces;
}

double DurationOf(const std::vector<MeasuredSegment>& segments) {
  double duration = 0.0;
  for (const MeasuredSegment& segment : segments) duration += segment.duration();
  return duration;
}

}  // namespace fathom
