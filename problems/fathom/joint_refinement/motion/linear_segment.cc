// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/motion/linear_segment.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fathom {

void LayOutDurations(const std::vector<double>& time, LinearSegment* segment) {
  constexpr double kGrain = 1e-4;  // [s]
  std::map<long, int> known;
  segment->durations.clear();
  segment->duration_after.clear();
  for (size_t k = 0; k + 1 < time.size(); ++k) {
    const long grains = std::max(1L, std::lround((time[k + 1] - time[k]) / kGrain));
    const auto [entry, is_new] =
        known.try_emplace(grains, static_cast<int>(segment->durations.size()));
    if (is_new) segment->durations.push_back(kGrain * static_cast<double>(grains));
    segment->duration_after.push_back(entry->second);
  }
}

}  // namespace fathom
