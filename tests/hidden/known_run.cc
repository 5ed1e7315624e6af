// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "known_run.h"

#include "fathom/signal/pose_velocity.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

namespace fathom::hidden {
namespace {

// Poses are used from here on: their clock may be off by this much, and the run must have begun.
constexpr double kPosesFrom = 2.0;  // [s]

double MeanOfFirst(const std::vector<double>& values, std::size_t count) {
  double sum = 0.0;
  count = std::min(count, values.size());
  for (std::size_t i = 0; i < count; ++i) sum += values[i];
  return sum / static_cast<double>(count);
}

}  // namespace

EffectInputs UnsmoothedInputsOf(const Log& log, Dof dof) {
  EffectInputs inputs;
  inputs.dof = dof;
  for (const Dof other : kAllDofs) {
    if (const auto* force = log.command->Find(ForceColumn(other))) {
      inputs.force[Index(other)] = {log.command->time, *force};
    }
    if (const auto* velocity = log.velocity->Find(VelocityColumn(other))) {
      inputs.velocity[Index(other)] = {log.velocity->time, *velocity};
    }
  }
  inputs.command = inputs.force[Index(dof)];
  CHECK(!inputs.command.time.empty());
  return inputs;
}

KnownRun::KnownRun(const Log& log, Dof dof, double from, double to, const KnownNoise& noise)
    : inputs_(std::make_unique<EffectInputs>(UnsmoothedInputsOf(log, dof))) {
  OutputStamps stamps;
  std::vector<double> velocities, displacements;
  const std::vector<double>& velocity = *log.velocity->Find(VelocityColumn(dof));
  from = std::max(from, time_zero());
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const double t = log.velocity->time[i];
    if (t < from || t >= to) continue;
    if (std::binary_search(noise.outlier_stamps.begin(), noise.outlier_stamps.end(), t)) continue;
    stamps.velocity.push_back(t);
    velocities.push_back(velocity[i]);
  }
  CHECK_GT(velocities.size(), 20u) << log.name;
  stamps.start = stamps.velocity.front();
  if (noise.use_poses) {
    const Poses poses = PosesOf(*log.pose);
    const std::vector<double> displacement = DisplacementAlong(dof, poses);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (poses.time[i] < stamps.start + kPosesFrom || poses.time[i] >= to) continue;
      stamps.displacement.push_back(poses.time[i]);
      displacements.push_back(displacement[i]);
    }
  }
  std::size_t v = 0, x = 0;
  while (v < velocities.size() || x < displacements.size()) {
    const bool is_velocity =
        x == displacements.size() ||
        (v < velocities.size() && stamps.velocity[v] <= stamps.displacement[x]);
    NoiseSample sample;
    sample.channel = is_velocity ? NoiseChannel::kVelocity : NoiseChannel::kDisplacement;
    sample.time = is_velocity ? stamps.velocity[v] : stamps.displacement[x];
    samples_.push_back(sample);
    measured_.push_back(is_velocity ? velocities[v] : displacements[x]);
    row_.push_back(static_cast<int>(is_velocity ? v++ : x++));
  }
  first_guess_.velocity = MeanOfFirst(velocities, 5);
  if (!displacements.empty()) first_guess_.position = MeanOfFirst(displacements, 5);
  whitener_ = std::make_unique<Whitener>(noise.model, samples_);
  simulation_ = std::make_unique<EffectSimulation>(inputs_.get(), std::move(stamps));
}

bool KnownRun::Residual(const ExtendedModel& model,
                        const InitialState& initial,
                        Eigen::VectorXd* residual) const {
  EffectOutputs outputs;
  if (!simulation_->Run(model, initial, &outputs)) return false;
  residual->resize(num_samples());
  for (int i = 0; i < num_samples(); ++i) {
    const bool is_velocity = samples_[i].channel == NoiseChannel::kVelocity;
    (*residual)[i] =
        measured_[i] - (is_velocity ? outputs.velocity[row_[i]] : outputs.displacement[row_[i]]);
  }
  if (!residual->allFinite()) return false;
  const std::span<double> in_place(residual->data(), num_samples());
  whitener_->Apply(in_place, in_place);
  return true;
}

bool KnownRun::Linearise(const ExtendedModel& model,
                         const InitialState& initial,
                         Eigen::VectorXd* residual,
                         RowMajorMatrix* sensitivity) const {
  EffectOutputs outputs;
  if (!simulation_->RunWithSensitivities(model, initial, &outputs)) return false;
  // Nothing is remembered from before these logs: those columns are not looked at.
  const int num_columns = EffectSimulation::NumColumns(model) -
                          static_cast<int>(EffectSimulation::ExcessesOf(model).size());
  RowMajorMatrix all(num_samples(), num_columns + 1);
  for (int i = 0; i < num_samples(); ++i) {
    const bool is_velocity = samples_[i].channel == NoiseChannel::kVelocity;
    const int row = row_[i];
    all(i, num_columns) =
        measured_[i] - (is_velocity ? outputs.velocity[row] : outputs.displacement[row]);
    const auto& all_columns =
        is_velocity ? outputs.velocity_sensitivity : outputs.displacement_sensitivity;
    all.row(i).head(num_columns) = all_columns.row(row).head(num_columns);
  }
  if (!all.allFinite()) return false;
  whitener_->Apply(all, all);
  *residual = all.col(num_columns);
  *sensitivity = all.leftCols(num_columns);
  return true;
}

bool KnownRun::Pretend(const ExtendedModel& model, const InitialState& initial) {
  EffectOutputs outputs;
  if (!simulation_->Run(model, initial, &outputs)) return false;
  for (int i = 0; i < num_samples(); ++i) {
    const bool is_velocity = samples_[i].channel == NoiseChannel::kVelocity;
    measured_[i] = is_velocity ? outputs.velocity[row_[i]] : outputs.displacement[row_[i]];
  }
  return true;
}

double KnownRun::Nmae(const ExtendedModel& model, const InitialState& initial) const {
  EffectOutputs outputs;
  if (!simulation_->Run(model, initial, &outputs)) return std::nan("");
  double error = 0.0, size = 0.0;
  for (int i = 0; i < num_samples(); ++i) {
    if (samples_[i].channel != NoiseChannel::kVelocity) continue;
    error += std::abs(measured_[i] - outputs.velocity[row_[i]]);
    size += std::abs(measured_[i]);
  }
  return error / size;
}

}  // namespace fathom::hidden
