// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/pass.h"

#include "fathom/signal/filters/integral.h"
#include "fathom/simulate/run_start.h"

#include <algorithm>

namespace fathom {

std::vector<PassSegment> PassOver(std::span<const Segment> segments) {
  std::vector<PassSegment> pass;
  for (const Segment& segment : segments) {
    if (segment.time.empty()) continue;
    const std::vector<double> impulse = IntegralsOf(segment.command, segment.time).once;
    const size_t n = segment.time.size();
    std::vector<double> force(n);
    for (size_t i = 0; i + 1 < n; ++i) {
      force[i] = (impulse[i + 1] - impulse[i]) / (segment.time[i + 1] - segment.time[i]);
    }
    force[n - 1] = segment.command.At(segment.time[n - 1]);
    pass.push_back({segment.time, std::move(force), segment.velocity, InitialVelocity(segment)});
  }
  std::sort(pass.begin(), pass.end(), [](const PassSegment& a, const PassSegment& b) {
    return a.time.front() < b.time.front();
  });
  return pass;
}

}  // namespace fathom
