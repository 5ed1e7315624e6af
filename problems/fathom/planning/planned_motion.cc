// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/planned_motion.h"

#include "fathom/simulate/effect_simulation.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/parameters.h"

#include <cmath>

namespace fathom {
namespace {

// With a column of the position at the start behind it.
Eigen::MatrixXd WithPosition(const Eigen::MatrixXd& by_start) {
  Eigen::MatrixXd columns(by_start.rows(), by_start.cols() + 1);
  columns << by_start, Eigen::VectorXd::Ones(by_start.rows());
  return columns;
}

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
    std::vector<double> of_displacement(columns.size());
    is_finite = simulation.RunWithSensitivities(
        model, {}, motion.velocity, motion.displacement, columns, of_displacement);
    const auto behind_start = [&](const std::vector<double>& values) {
      const Eigen::Map<const SensitivityMatrix> all(
          values.data(), static_cast<Eigen::Index>(num_outputs), Simulation::kNumSensitivities);
      return Eigen::MatrixXd(all.bottomRows(all.rows() - 1));
    };
    const Eigen::MatrixXd velocity = behind_start(columns);
    const Eigen::MatrixXd displacement = behind_start(of_displacement);
    derivatives->by_parameter = velocity.leftCols(kNumParameters);
    derivatives->by_start = velocity.rightCols(1);
    derivatives->displacement_by_parameter = displacement.leftCols(kNumParameters);
    derivatives->displacement_by_start = WithPosition(displacement.rightCols(1));
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
    const auto num_excesses = static_cast<Eigen::Index>(EffectSimulation::ExcessesOf(model).size());
    const auto by_parameter = [&](const SensitivityMatrix& all) {
      const Eigen::Index num_effect_columns =
          all.cols() - EffectSimulation::kFirstEffectColumn - num_excesses;
      Eigen::MatrixXd columns(all.rows(), kNumParameters + num_effect_columns);
      columns << all.leftCols(kNumParameters),
          all.middleCols(EffectSimulation::kFirstEffectColumn, num_effect_columns);
      return columns;
    };
    const auto by_start = [&](const SensitivityMatrix& all) {
      Eigen::MatrixXd columns(all.rows(), 1 + num_excesses);
      columns << all.col(EffectSimulation::kInitialVelocityColumn), all.rightCols(num_excesses);
      return columns;
    };
    derivatives->by_parameter = by_parameter(outputs.velocity_sensitivity);
    derivatives->by_start = by_start(outputs.velocity_sensitivity);
    derivatives->displacement_by_parameter = by_parameter(outputs.displacement_sensitivity);
    derivatives->displacement_by_start = WithPosition(by_start(outputs.displacement_sensitivity));
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

std::vector<double> LimitStamps(double hold, double duration, double coarsest) {
  constexpr double kSlack = 1e-9;
  const double period = hold > coarsest ? hold / std::ceil(hold / coarsest - kSlack)
                                        : hold * std::floor(coarsest / hold + kSlack);
  return PlannedStamps(duration, period);
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
