// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "surge_run.h"

#include "fathom/synthesize/effects/parse_hidden_effects.h"
#include "fathom/synthesize/synthesize.h"

#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

namespace fathom {

InputSignal Multisine(double rms) {
  MultisineInput sines;
  sines.rms = rms;
  sines.lowest_frequency = 0.06;
  sines.highest_frequency = 1.6;
  sines.num_lines = 12;
  return {0.0, sines};
}

InputSignal Sine(double amplitude, double frequency) {
  return {0.0, SineInput{.amplitude = amplitude, .frequency = frequency, .phase = 0.0}};
}

InputSignal Square(double amplitude, double period) {
  return {0.0, SquareInput{.amplitude = amplitude, .frequency = 2.0 * std::numbers::pi / period}};
}

InputSignal Steps(std::vector<double> levels, double hold) {
  return {0.0, StepsInput{.levels = std::move(levels), .hold = hold}};
}

Log LogOf(const SurgeRun& run, std::uint64_t seed) {
  Vehicle vehicle;
  vehicle.name = "flatfish";
  vehicle.models[Index(Dof::kSurge)] = run.model;
  Experiment experiment;
  experiment.name = run.name;
  experiment.duration = run.duration;
  experiment.command_rate = run.rate;
  Drive drive;
  drive.dof = Dof::kSurge;
  drive.input = run.input;
  drive.turbulence = {.force = run.turbulence, .correlation_time = 3.0};
  experiment.drives = {drive};
  if (run.has_velocity) {
    experiment.velocity.emplace();
    experiment.velocity->sampling.rate = run.rate;
    experiment.velocity->noise[Index(Dof::kSurge)] = run.velocity_noise;
    experiment.velocity->noise_correlation = run.noise_correlation;
  }
  if (run.has_poses) {
    experiment.pose.emplace();
    experiment.pose->sampling.rate = run.rate;
    experiment.pose->position_noise = run.position_noise;
  }
  std::vector<ActiveEffect> effects = run.more;
  if (!run.effects.empty()) {
    const auto scales = ScalesOf(vehicle, experiment, seed);
    for (ActiveEffect& active : ParseHiddenEffects(run.effects, experiment, scales, seed)) {
      effects.push_back(std::move(active));
    }
  }
  return Synthesize(vehicle, experiment, effects, seed);
}

Log WithoutMotion(Log log, double from, double to) {
  for (std::optional<Stream>* stream : {&log.velocity, &log.pose}) {
    if (!*stream) continue;
    const Stream all = std::exchange(**stream, {{}, (*stream)->columns, {}});
    (*stream)->values.resize(all.values.size());
    for (std::size_t i = 0; i < all.time.size(); ++i) {
      if (from <= all.time[i] && all.time[i] < to) continue;
      (*stream)->time.push_back(all.time[i]);
      for (std::size_t k = 0; k < all.values.size(); ++k) {
        (*stream)->values[k].push_back(all.values[k][i]);
      }
    }
  }
  return log;
}

}  // namespace fathom
