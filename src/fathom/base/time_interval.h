// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace fathom {

// From `from` up to, not including, `to` [s].
struct TimeInterval {
  double from = 0.0;
  double to = 0.0;

  bool Contains(double t) const { return from <= t && t < to; }
};

// In tenths of a second, with both ends in it.
inline TimeInterval OutToTenths(const TimeInterval& interval) {
  return {std::floor(10.0 * interval.from) / 10.0, (std::floor(10.0 * interval.to) + 1.0) / 10.0};
}

}  // namespace fathom
