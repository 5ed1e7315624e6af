// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/outliers.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr int kReach = 5;       // neighbours on either side
constexpr double kLimit = 6.0;  // robust standard deviations

double Quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  const auto at = values.begin() + std::min<std::ptrdiff_t>(place, std::ssize(values) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Standard deviation of the usual samples. A sensor with coarse steps, or a vehicle that rests for
// half of the run, leaves a median near zero: what most samples keep to counts as well.
double UsualSpread(const std::vector<double>& sizes) {
  struct Normal {
    double share, quantile;  // of the size of a standard normal number
  };
  double spread = 0.0;
  for (const auto& [share, quantile] : {Normal{0.5, 0.6745}, {0.8, 1.2816}, {0.9, 1.6449}}) {
    spread = std::max(spread, Quantile(sizes, share) / quantile);
  }
  return spread;
}

// Removes the wild samples of one channel, whose noise has this variance over the usual (empty: all
// alike).
int RemoveFrom(const std::vector<double>& simulated,
               std::vector<double>* time,
               std::vector<double>* measured,
               std::vector<double>* variance) {
  const int n = static_cast<int>(time->size());
  if (n < 2 * kReach + 1) return 0;
  std::vector<double> residual, deviation;
  for (int i = 0; i < n; ++i) residual.push_back((*measured)[i] - simulated[i]);
  for (int i = 0; i < n; ++i) {
    const int first = std::clamp(i - kReach, 0, n - 2 * kReach - 1);
    const auto begin = residual.begin() + first;
    deviation.push_back(residual[i] - Median({begin, begin + 2 * kReach + 1}));
    if (!variance->empty()) deviation.back() /= std::sqrt((*variance)[i]);
  }
  std::vector<double> sizes;
  for (const double d : deviation) sizes.push_back(std::abs(d));
  const double spread = UsualSpread(sizes);
  if (!(spread > 0.0)) return 0;
  std::vector<double> kept_time, kept, kept_variance;
  for (int i = 0; i < n; ++i) {
    if (std::abs(deviation[i]) > kLimit * spread) continue;
    kept_time.push_back((*time)[i]);
    kept.push_back((*measured)[i]);
    if (!variance->empty()) kept_variance.push_back((*variance)[i]);
  }
  *time = std::move(kept_time);
  *measured = std::move(kept);
  *variance = std::move(kept_variance);
  return n - static_cast<int>(time->size());
}

}  // namespace

int RemoveOutliers(const ExtendedModel& model,
                   const std::vector<InitialState>& initial,
                   std::vector<MeasuredSegment>* segments) {
  int num_removed = 0;
  for (size_t r = 0; r < segments->size(); ++r) {
    MeasuredSegment& segment = (*segments)[r];
    EffectOutputs outputs;
    const EffectSimulation simulation(segment.inputs.get(), segment.stamps);
    if (!simulation.Run(model, initial[r], &outputs)) continue;
    std::vector<double> all_alike;
    num_removed +=
        RemoveFrom(outputs.velocity, &segment.stamps.velocity, &segment.velocity, &all_alike);
    num_removed += RemoveFrom(outputs.displacement,
                              &segment.stamps.displacement,
                              &segment.displacement,
                              &segment.displacement_variance);
  }
  return num_removed;
}

}  // namespace fathom
