// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/damping_factors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {

void SetDampingFactors(std::span<const double> time,
                       std::span<const double> damping,
                       double usual,
                       std::span<NoiseSample> samples) {
  constexpr double kStepsPerOctave = 4.0;
  constexpr double kMostOctaves = 3.0;
  if (!(usual > 0.0)) return;
  std::size_t next = 0;
  double mean = usual;
  for (NoiseSample& sample : samples) {
    double sum = 0.0, n = 0.0;
    for (; next < time.size() && time[next] <= sample.time; ++next, n += 1.0) sum += damping[next];
    if (n > 0.0) mean = sum / n;
    const double octaves = std::log2(std::max(mean, 1e-300) / usual);
    sample.damping_factor =
        std::exp2(std::round(kStepsPerOctave * std::clamp(octaves, -kMostOctaves, kMostOctaves)) /
                  kStepsPerOctave);
  }
}

}  // namespace fathom
