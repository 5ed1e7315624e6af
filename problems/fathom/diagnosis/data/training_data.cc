// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/training_data.h"

#include "fathom/base/parallel_for.h"
#include "fathom/noise/damping_factors.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fathom {
namespace {

constexpr std::int64_t kStepsOfOneWithDerivatives = 6;

// At the stamps of a segment.
std::vector<double> DampingAlong(const Segment& segment, const UncoupledModel<double>& model) {
  std::vector<double> damping;
  damping.reserve(segment.velocity.size());
  for (const double v : segment.velocity) damping.push_back(model.DampingSlope(v));
  return damping;
}

}  // namespace

TrainingData::TrainingData(std::vector<MeasuredSegment> segments,
                           const UncoupledModel<double>& about,
                           double least_inertia)
    : segments_(std::move(segments)),
      bins_(segments_),
      samples_(bins_.samples()),
      least_inertia_(least_inertia) {
  command_tone_.share = 1.0;
  for (const MeasuredSegment& segment : segments_) {
    duration_ += segment.duration();
    longest_duration_ = std::max(longest_duration_, segment.duration());
    const HeldCommand& command = segment.inputs->command;
    for (const double force : command.value) most_force_ = std::max(most_force_, std::abs(force));
    if (segment.command_tone.share <= command_tone_.share) command_tone_ = segment.command_tone;
  }
  measured_.resize(bins_.size());
  for (size_t r = 0; r < segments_.size(); ++r) {
    simulations_.emplace_back(segments_[r].inputs.get(), segments_[r].stamps);
    has_displacement_ = has_displacement_ || !segments_[r].displacement.empty();
    const int first = bins_.first_row(r);
    bins_.Average(r,
                  segments_[r].velocity,
                  segments_[r].displacement,
                  std::span(measured_.data() + first, bins_.first_row(r + 1) - first));
  }
  SetDamping(about);
}

void TrainingData::SetDamping(const UncoupledModel<double>& about) {
  std::vector<Segment> plain_segments;
  double sum = 0.0, n = 0.0;
  for (const MeasuredSegment& segment : segments_) {
    plain_segments.push_back(PlainSegment(segment));
    for (const double v : plain_segments.back().velocity) sum += std::abs(v);
    n += static_cast<double>(plain_segments.back().velocity.size());
  }
  usual_speed_ = n > 0.0 ? sum / n : 0.0;
  for (size_t r = 0; r < segments_.size(); ++r) {
    const int first = bins_.first_row(r);
    SetDampingFactors(plain_segments[r].time,
                      DampingAlong(plain_segments[r], about),
                      about.DampingSlope(usual_speed_),
                      std::span(samples_).subspan(first, bins_.first_row(r + 1) - first));
  }
}

double TrainingData::DampingRate(const UncoupledModel<double>& model) const {
  constexpr double kLeast = 1e-3, kMost = 5.0;  // [1/s]
  return std::clamp(model.DampingSlope(usual_speed_) / model.inertia, kLeast, kMost);
}

double TrainingData::most_offset() const {
  constexpr double kShare = 0.125;
  const double half_period = command_tone_.IsAlone() ? std::numbers::pi / command_tone_.frequency
                                                     : std::numeric_limits<double>::infinity();
  return std::min(kShare * longest_duration_, half_period);
}

std::optional<Eigen::VectorXd> TrainingData::Simulate(const ExtendedModel& model,
                                                      std::span<const InitialState> initial) const {
  return SimulateLog("", model, initial, Eigen::VectorXd(bins_.size()));
}

std::optional<Eigen::VectorXd> TrainingData::SimulateLog(const std::string& log,
                                                         const ExtendedModel& model,
                                                         std::span<const InitialState> initial,
                                                         Eigen::VectorXd simulated) const {
  EffectOutputs outputs;
  for (size_t r = 0; r < segments_.size(); ++r) {
    if (!log.empty() && segments_[r].log != log) continue;
    const bool is_simulated = simulations_[r].Run(model, initial[r], &outputs);
    *work_ += outputs.num_steps;
    if (!is_simulated) return std::nullopt;
    const int first = bins_.first_row(r);
    bins_.Average(r,
                  outputs.velocity,
                  outputs.displacement,
                  std::span(simulated.data() + first, bins_.first_row(r + 1) - first));
  }
  return simulated;
}

std::optional<TrainingData::Linearised> TrainingData::Linearise(
    const ExtendedModel& model, std::span<const InitialState> initial) const {
  const int num_parameters = EffectSimulation::NumParameters(model);
  const int num_states = this->num_states(model);
  const int num_columns = num_parameters + num_states * static_cast<int>(segments_.size());
  Linearised linearised = {Eigen::VectorXd(bins_.size()),
                           RowMajorMatrix::Zero(bins_.size(), num_columns)};
  std::atomic<bool> is_simulated = true;
  ParallelFor(static_cast<int>(segments_.size()), [&](int r) {
    EffectOutputs outputs;
    const bool is_run = simulations_[r].RunWithSensitivities(model, initial[r], &outputs);
    *work_ += kStepsOfOneWithDerivatives * outputs.num_steps;
    if (!is_run) {
      is_simulated = false;
      return;
    }
    const int first = bins_.first_row(r);
    const int num_rows = bins_.first_row(r + 1) - first;
    bins_.Average(r,
                  outputs.velocity,
                  outputs.displacement,
                  std::span(linearised.simulated.data() + first, num_rows));
    SensitivityMatrix rows(num_rows, EffectSimulation::NumColumns(model));
    bins_.Average(r, outputs.velocity_sensitivity, outputs.displacement_sensitivity, rows);
    auto to = linearised.jacobian.middleRows(first, num_rows);
    to.leftCols(kNumParameters) = rows.leftCols(kNumParameters);
    const int num_effect_parameters = num_parameters - kNumParameters;
    to.middleCols(kNumParameters, num_effect_parameters) =
        rows.middleCols(EffectSimulation::kFirstEffectColumn, num_effect_parameters);
    const int state = num_parameters + num_states * r;
    to.col(state) = rows.col(EffectSimulation::kInitialVelocityColumn);
    if (has_displacement_) {
      to.col(state + 1) = rows.col(EffectSimulation::kInitialPositionColumn);
    }
    const int num_excesses = num_states - (has_displacement_ ? 2 : 1);
    to.middleCols(state + num_states - num_excesses, num_excesses) = rows.rightCols(num_excesses);
  });
  if (!is_simulated) return std::nullopt;
  return linearised;
}

}  // namespace fathom
