// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/prediction.h"

#include "fathom/simulate/simulate.h"

#include <cmath>

namespace fathom {

std::vector<Segment> SegmentsAtEveryStamp(const std::vector<double>& time,
                                          const std::vector<double>& velocity,
                                          const HeldCommand& command,
                                          double longest_gap) {
  std::vector<Segment> segments;
  for (size_t i = 0; i < time.size(); ++i) {
    if (i == 0 || time[i] - time[i - 1] > longest_gap) {
      segments.emplace_back();
      segments.back().command = command;
    }
    segments.back().time.push_back(time[i]);
    segments.back().velocity.push_back(velocity[i]);
  }
  return segments;
}

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

FitFigures FiguresOf(const UncoupledModel<double>& model, std::span<const Segment> segments) {
  FitFigures figures;
  double sum_of_errors = 0.0, sum_of_speeds = 0.0;
  for (const Segment& segment : segments) {
    const auto predicted = PredictVelocity(model, segment, InitialVelocity(segment));
    if (!predicted) return {};
    for (size_t i = 0; i < segment.time.size(); ++i) {
      sum_of_errors += std::abs((*predicted)[i] - segment.velocity[i]);
      sum_of_speeds += std::abs(segment.velocity[i]);
    }
    figures.num_samples += static_cast<int>(segment.time.size());
    figures.duration += segment.time.back() - segment.time.front();
  }
  if (figures.num_samples == 0) return {};
  figures.mae = sum_of_errors / figures.num_samples;                      // docs/models.md (7)
  if (sum_of_speeds > 0.0) figures.nmae = sum_of_errors / sum_of_speeds;  // docs/models.md (8)
  return figures;
}

}  // namespace fathom
