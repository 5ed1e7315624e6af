// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/outliers.h"

#include "fathom/signal/filters/wild_samples.h"

#include <utility>

namespace fathom {
namespace {

// Removes the wild samples of one channel, whose noise has this variance over the usual (empty: all
// alike).
int RemoveFrom(const std::vector<double>& simulated,
               std::vector<double>* time,
               std::vector<double>* measured,
               std::vector<double>* variance) {
  const int n = static_cast<int>(time->size());
  std::vector<double> residual;
  for (int i = 0; i < n; ++i) residual.push_back((*measured)[i] - simulated[i]);
  const std::vector<bool> is_wild = WildSamples(residual, *variance);
  std::vector<double> kept_time, kept, kept_variance;
  for (int i = 0; i < n; ++i) {
    if (is_wild[i]) continue;
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
