// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/proposed_held_out.h"

#include <algorithm>

namespace fathom {

TimeInterval ProposedHeldOut(std::span<const TimeInterval> stretches) {
  double left = 0.0;
  for (const TimeInterval& stretch : stretches) left += kHeldOutShare * (stretch.to - stretch.from);
  TimeInterval held_out = stretches.back();
  for (auto stretch = stretches.rbegin(); stretch != stretches.rend() && left > 0.0; ++stretch) {
    held_out.from = std::max(stretch->from, stretch->to - left);
    left -= stretch->to - stretch->from;
  }
  return held_out;
}

}  // namespace fathom
