// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/planned_motion.h"

#include "fathom/simulate/effect_simulation.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/parameters.h"

#include <cmath>

namespace fathom {
namespace {

// Without effects: columns are the parameters, then the initial velocity.
std::optional<PlannedMotion> BaselineMotion(const UncoupledModel<double>& model,
                                            const HeldCommand& command,
                                            std::span<const double> stamps,
                                            MotionDerivatives* derivatives) {
  // A simulation starts at its first output.
  std::vector<double> with_start = {0.0};
  with_start.insert(with_start.end(), stamps.begin(), stamps.end());
  const std::size_t num_outputs = with_start.size();
  const Simulation simulation(command, with_start);
  PlannedMotion motion = {std::vector<double>(num_outputs), std::vector<double>(num_outputs)};
  bool is_finite = false;
  if (derivatives == nullptr) {
    is_finite = simulation.Run(model, {}, motion.velocity, motion.displacement);
  } else {
    std::vector<double> columns(num_outputs * Simulation::kNumSensitivities);
    is_finite = simulation.RunWithSensitivities(
        model, {}, motion.velocity, motion.displacement, columns, {});
    const Eigen::Map<const SensitivityMatrix> all(
        columns.data(), static_cast<Eigen::Index>(num_outputs), Simulation::kNumSensitivities);
    const auto behind_start = all.bottomRows(all.rows() - 1);
    derivatives->by_parameter = behind_start.leftCols(kNumParameters);
    derivatives->by_start = behind_start.rightCols(1);
  }
  if (!is_finite) return std::nullopt;
  motion.velocity.erase(motion.velocity.begin());
  motion.displacement.erase(motion.displacement.begin());
  return motion;
}

std::optional<PlannedMotion> MotionWithEffects(const ExtendedModel& model,
                                               Dof dof,
                                               const HeldCommand& command,
                                               std::span<const double> stamps,
                                               MotionDerivatives* derivatives) {
  EffectInputs inputs;
  inputs.dof = dof;
  inputs.command = command;
  inputs.force[Index(dof)] = command;
  const EffectSimulation simulation(
      &inputs, {0.0, {stamps.begin(), stamps.end()}, {stamps.begin(), stamps.end()}});
  EffectOutputs outputs;
  const bool is_finite = derivatives == nullptr
                             ? simulation.Run(model, {}, &outputs)
                             : simulation.RunWithSensitivities(model, {}, &outputs);
  if (!is_finite) return std::nullopt;
  if (derivatives != nullptr) {
    const SensitivityMatrix& all = outputs.velocity_sensitivity;
    const auto num_excesses = static_cast<Eigen::Index>(EffectSimulation::ExcessesOf(model).size());
    const Eigen::Index num_effect_columns =
        all.cols() - EffectSimulation::kFirstEffectColumn - num_excesses;
    derivatives->by_parameter.resize(all.rows(), kNumParameters + num_effect_columns);
    derivatives->by_parameter << all.leftCols(kNumParameters),
        all.middleCols(EffectSimulation::kFirstEffectColumn, num_effect_columns);
    derivatives->by_start.resize(all.rows(), 1 + num_excesses);
    derivatives->by_start << all.col(EffectSimulation::kInitialVelocityColumn),
        all.rightCols(num_excesses);
  }
  return PlannedMotion{std::move(outputs.velocity), std::move(outputs.displacement)};
}

}  // namespace

std::vector<double> PlannedStamps(double duration, double period) {
  std::vector<double> stamps;
  const int num_stamps = static_cast<int>(std::floor(duration / period + 1e-9));
  for (int i = 1; i <= num_stamps; ++i) stamps.push_back(i * period);
  return stamps;
}

std::optional<PlannedMotion> MotionUnder(const ExtendedModel& model,
                                         Dof dof,
                                         const HeldCommand& command,
                                         std::span<const double> stamps,
                                         MotionDerivatives* derivatives) {
  if (model.effects.empty()) {
    return BaselineMotion(model.baseline, command, stamps, derivatives);
  }
  return MotionWithEffects(model, dof, command, stamps, derivatives);
}

}  // namespace fathom
