// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/extended_prediction.h"

#include "fathom/signal/pose_velocity.h"
#include "fathom/simulate/prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glog/logging.h>

namespace fathom {

std::optional<std::vector<double>> PredictReadings(const ExtendedModel& model,
                                                   const EffectInputs& inputs,
                                                   const std::vector<double>& time,
                                                   const InitialState& initial) {
  EffectOutputs outputs;
  const EffectSimulation simulation(&inputs, {time.front(), time, {}});
  if (!simulation.Run(model, initial, &outputs)) return std::nullopt;
  return outputs.velocity;
}

double VelocityBehind(const ExtendedModel& model,
                      const EffectInputs& inputs,
                      double time,
                      double reading) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  // Near the reading, where a run that diverges from afar does not.
  const double probes[] = {reading, reading + 0.1};
  double shown[2];
  for (int k = 0; k < 2; ++k) {
    const auto run = PredictReadings(model, inputs, {time}, {probes[k], 0.0});
    if (!run) return kNone;
    shown[k] = run->front();
  }
  const double slope = (shown[1] - shown[0]) / (probes[1] - probes[0]);
  return slope == 0.0 ? kNone : probes[0] + (reading - shown[0]) / slope;
}

double PositionAt(const Log& log, Dof dof, double time) {
  if (!log.pose) return 0.0;
  const Poses poses = PosesOf(*log.pose);
  const std::vector<double> position = DisplacementAlong(dof, poses).value;
  const auto next = std::lower_bound(poses.time.begin(), poses.time.end(), time);
  if (next == poses.time.begin()) return position.front();
  if (next == poses.time.end()) return position.back();
  const auto i = static_cast<std::size_t>(next - poses.time.begin());
  const double share = (time - poses.time[i - 1]) / (poses.time[i] - poses.time[i - 1]);
  return position[i - 1] + share * (position[i] - position[i - 1]);
}

FitFigures FiguresOf(const ExtendedModel& model,
                     const EffectInputs& inputs,
                     std::span<const Segment> segments,
                     std::span<const double> positions) {
  CHECK_EQ(segments.size(), positions.size());
  FitFigures figures;
  double sum_of_errors = 0.0, sum_of_speeds = 0.0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Segment& segment = segments[k];
    const double start =
        VelocityBehind(model, inputs, segment.time.front(), InitialVelocity(segment));
    if (!std::isfinite(start)) return {};
    const auto shown = PredictReadings(model, inputs, segment.time, {start, positions[k]});
    if (!shown) return {};
    for (std::size_t i = 0; i < segment.time.size(); ++i) {
      sum_of_errors += std::abs((*shown)[i] - segment.velocity[i]);
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
