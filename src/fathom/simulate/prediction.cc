// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/prediction.h"

#include "fathom/simulate/simulate.h"

#include <cmath>

namespace fathom {

std::optional<std::vector<double>> PredictVelocity(const UncoupledModel<double>& model,
                                                   const Segment& segment,
                                                   double initial_velocity) {
  std::vector<double> velocity(segment.time.size());
  const Simulation simulation(segment.command, segment.time);
  if (!simulation.Run(model, {initial_velocity, 0.0}, velocity, {})) return std::nullopt;
  return velocity;
}

double InitialVelocity(const Segment& segment) {
  return std::isfinite(segment.initial_velocity) ? segment.initial_velocity
                                                 : segment.velocity.front();
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

FitFigures FiguresOf(const UncoupledModel<double>& model, std::span<const Segment> segments) {
  FigureSums sums;
  for (const Segment& segment : segments) {
    const auto predicted = PredictVelocity(model, segment, InitialVelocity(segment));
    if (!predicted) return {};
    sums.Add(segment.time, segment.velocity, *predicted);
  }
  return sums.Figures();
}

}  // namespace fathom
