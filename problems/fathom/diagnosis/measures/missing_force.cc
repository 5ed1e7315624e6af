// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/missing_force.h"

#include "fathom/noise/smooth_disturbance.h"
#include "fathom/simulate/partner_signals.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace fathom {
namespace {

constexpr double kCommandRateStep = 0.5;  // [s]

// Of the rows of one channel; 0 if it has none.
double RmsOf(const Eigen::VectorXd& values,
             const std::vector<NoiseSample>& samples,
             NoiseChannel channel) {
  double sum = 0.0, count = 0.0;
  for (std::size_t row = 0; row < samples.size(); ++row) {
    if (samples[row].channel != channel) continue;
    sum += values(static_cast<Eigen::Index>(row)) * values(static_cast<Eigen::Index>(row));
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

// With a disturbance strong enough to carry what the baseline misses, in speed or in place.
NoiseModel WithDisturbance(NoiseModel noise,
                           double damping_rate,
                           const std::vector<NoiseSample>& samples,
                           const Eigen::VectorXd& residual) {
  noise.damping_rate = damping_rate;
  noise.disturbance.time = 1.5;
  const double time = noise.disturbance.time;
  const double missed = std::max({RmsOf(residual, samples, NoiseChannel::kVelocity),
                                  RmsOf(residual, samples, NoiseChannel::kDisplacement) / time,
                                  1e-9});
  noise.disturbance.std = std::max(noise.disturbance.std, missed / time);
  return noise;
}

// The next one that was measured; nothing if none is.
std::optional<double> MeasuredDisplacement(const MeasuredSegment& segment, double t) {
  const std::vector<double>& stamps = segment.stamps.displacement;
  if (stamps.empty()) return std::nullopt;
  const auto next = std::lower_bound(stamps.begin(), stamps.end(), t);
  return segment.displacement[std::min(next - stamps.begin(), std::ssize(stamps) - 1)];
}

}  // namespace

MissingForce FindMissingForce(const TrainingData& data,
                              const StartedModel& baseline,
                              const StartedModel& extended,
                              const NoiseModel& noise,
                              const std::vector<Dof>& partners) {
  MissingForce missing;
  const auto& samples = data.samples();
  const double inertia = baseline.model.baseline.inertia;
  const NoiseModel wandering =
      WithDisturbance(noise, data.DampingRate(baseline.model.baseline), samples, baseline.residual);
  const SmoothedDisturbance smoothed = SmoothDisturbance(
      wandering, samples, std::span(baseline.residual.data(), baseline.residual.size()));
  const Eigen::VectorXd added = baseline.residual - extended.residual;
  const SmoothedDisturbance explained =
      SmoothDisturbance(wandering, samples, std::span(added.data(), added.size()));
  for (const Dof partner : partners) missing.partner_names.emplace_back(Name(partner));
  missing.partner_velocities.resize(partners.size());

  for (size_t r = 0; r < data.segments().size(); ++r) {
    const MeasuredSegment& segment = data.segments()[r];
    std::vector<double> times;
    std::vector<int> rows;
    for (int row = data.bins().first_row(r); row < data.bins().first_row(r + 1); ++row) {
      if (!times.empty() && samples[row].time <= times.back()) continue;
      times.push_back(samples[row].time);
      rows.push_back(row);
    }
    OutputStamps stamps;
    stamps.start = segment.stamps.start;
    for (const double t : times) stamps.velocity.push_back(std::max(t, stamps.start));
    stamps.displacement = stamps.velocity;
    EffectOutputs run;
    if (!EffectSimulation(segment.inputs.get(), stamps)
             .Run(baseline.model, baseline.initial[r], &run)) {
      continue;
    }
    std::vector<PartnerSignals> signals;
    for (const Dof partner : partners) {
      signals.emplace_back(*segment.inputs, EffectSetting{.partner = partner});
    }
    for (size_t i = 0; i < times.size(); ++i) {
      const double t = times[i];
      missing.time.push_back(t);
      missing.mean.push_back(inertia * smoothed.mean[rows[i]]);
      missing.std.push_back(inertia * smoothed.std[rows[i]]);
      missing.explained.push_back(inertia * explained.mean[rows[i]]);
      missing.command.push_back(segment.inputs->command.At(t));
      missing.command_rate.push_back((segment.inputs->command.At(t + 0.5 * kCommandRateStep) -
                                      segment.inputs->command.At(t - 0.5 * kCommandRateStep)) /
                                     kCommandRateStep);
      missing.velocity.push_back(run.velocity[i]);
      // A model that misses much is soon elsewhere than the vehicle.
      missing.displacement.push_back(
          MeasuredDisplacement(segment, t).value_or(run.displacement[i]));
      for (size_t k = 0; k < partners.size(); ++k) {
        missing.partner_velocities[k].push_back(signals[k].At(t, t, t).velocity);
      }
    }
  }
  return missing;
}

ResidualTrace TraceOf(const MeasuredSegment& segment,
                      std::optional<FreeRun> before,
                      std::optional<FreeRun> after) {
  ResidualTrace trace;
  trace.log = segment.log;
  trace.is_held_out = segment.is_held_out;
  if (before) {
    trace.time = std::move(before->time);
    trace.measured = std::move(before->measured);
    trace.before = std::move(before->predicted);
  }
  if (after) trace.after = std::move(after->predicted);
  if (!trace.time.empty()) {
    trace.command = segment.inputs->command.Between(trace.time.front(), trace.time.back());
  }
  return trace;
}

}  // namespace fathom
