// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/pulse_widths.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace fathom {

std::optional<Finding> CheckPulseWidths(std::span<const Segment> segments) {
  constexpr double kShortest = 800.0, kLongest = 2200.0;  // [us]
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Segment& segment : segments) {
    for (const double value : segment.command.value) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(kShortest <= low && low <= high && high <= kLongest)) return std::nullopt;
  return Finding{Severity::kWarning,
                 "pulse_widths",
                 fmt::format("The command lies between {:.4g} and {:.4g} and is never near 0. Are "
                             "these pulse widths in us and no forces?",
                             low,
                             high)};
}

}  // namespace fathom
