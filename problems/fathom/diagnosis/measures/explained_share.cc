// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/explained_share.h"

#include "fathom/simulate/noise_floor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace fathom {
namespace {

// Of the scatter's variance: an error that is closer to it shows nothing beyond it.
constexpr double kLeastBeyondScatter = 0.02;

double SquaredError(std::span<const FreeRun> runs) {
  double sum = 0.0;
  for (const FreeRun& run : runs) {
    for (std::size_t i = 0; i < run.time.size(); ++i) {
      const double miss = run.measured[i] - run.predicted[i];
      sum += miss * miss;
    }
  }
  return sum;
}

double NumSamples(std::span<const FreeRun> runs) {
  double num_samples = 0.0;
  for (const FreeRun& run : runs) num_samples += static_cast<double>(run.time.size());
  return num_samples;
}

}  // namespace

double ExplainedShare(std::span<const SourceRuns> sources) {
  constexpr double kExact = 1e-12;  // of the error: data without noise have next to no scatter
  double removed = 0.0, beyond_scatter = 0.0, num_samples = 0.0;
  for (const SourceRuns& runs : sources) {
    const double before = SquaredError(runs.before), n = NumSamples(runs.before);
    const double variance = std::max(ScatterVariance(runs.after), kExact * before / n);
    if (!(variance > 0.0)) continue;
    removed += (before - SquaredError(runs.after)) / variance;
    beyond_scatter += before / variance - n;
    num_samples += n;
  }
  if (!(beyond_scatter > kLeastBeyondScatter * num_samples)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::clamp(removed / beyond_scatter, 0.0, 1.0);
}

}  // namespace fathom
