// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/data_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fathom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr ValueRange kNothing = {kInfinity, -kInfinity};

void Add(double value, ValueRange* range) {
  if (!std::isfinite(value)) return;
  range->low = std::min(range->low, value);
  range->high = std::max(range->high, value);
}

}  // namespace

std::optional<DataRange> RangeOf(std::span<const Segment> segments) {
  DataRange range = {kNothing, kNothing};
  for (const Segment& segment : segments) {
    if (segment.time.empty()) continue;
    for (const double speed : segment.velocity) Add(speed, &range.speed);
    const double from = segment.time.front(), to = segment.time.back();
    Add(segment.command.At(from), &range.force);
    for (const double force : segment.command.Between(from, to).value) Add(force, &range.force);
  }
  if (range.speed.low > range.speed.high || range.force.low > range.force.high) return std::nullopt;
  return range;
}

}  // namespace fathom
