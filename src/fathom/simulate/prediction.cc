// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/prediction.h"

#include "fathom/simulate/effect_simulation.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include <glog/logging.h>

namespace fathom {

std::optional<std::vector<double>> Predict(const ExtendedModel& model,
                                           const Segment& segment,
                                           const InitialState& initial,
                                           const EffectInputs* inputs) {
  CHECK(inputs != nullptr || model.effects.empty());
  const EffectInputs own = inputs == nullptr ? CommandOnly(segment) : EffectInputs();
  if (inputs == nullptr) inputs = &own;
  EffectOutputs outputs;
  const EffectSimulation simulation(inputs, {segment.time.front(), segment.time, {}});
  if (!simulation.Run(model, initial, &outputs)) return std::nullopt;
  return std::move(outputs.velocity);
}

void FigureSums::Add(std::span<const double> time,
                     std::span<const double> measured,
                     std::span<const double> predicted) {
  if (time.empty()) return;
  for (size_t i = 0; i < time.size(); ++i) {
    sum_of_errors_ += std::abs(predicted[i] - measured[i]);
    sum_of_speeds_ += std::abs(measured[i]);
  }
  num_samples_ += static_cast<int>(time.size());
  duration_ += time.back() - time.front();
}

FitFigures FigureSums::Figures() const {
  FitFigures figures;
  if (num_samples_ == 0) return figures;
  figures.num_samples = num_samples_;
  figures.duration = duration_;
  figures.mae = sum_of_errors_ / num_samples_;                               // docs/models.md (7)
  if (sum_of_speeds_ > 0.0) figures.nmae = sum_of_errors_ / sum_of_speeds_;  // docs/models.md (8)
  return figures;
}

}  // namespace fathom
