// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/segment_derivatives.h"

#include "fathom/simulate/effect_simulation.h"
#include "fathom/simulate/fitted_start.h"
#include "fathom/vehicle/parameters.h"

#include <utility>

namespace fathom {
namespace {

// Columns of a simulation with effects: the baseline's, the state at the start, the effects', the
// rest of the start. `num_of_state`: 1, the initial velocity alone, or 2, with the position.
void TakeColumns(const SensitivityMatrix& all,
                 const std::vector<bool>& of_run,
                 Eigen::Index num_of_state,
                 Eigen::MatrixXd* by_parameter,
                 Eigen::MatrixXd* by_start) {
  const auto num_parameters = static_cast<Eigen::Index>(of_run.size());
  const Eigen::Index num_effect_columns = num_parameters - kNumParameters;
  const Eigen::Index num_excesses =
      all.cols() - EffectSimulation::kFirstEffectColumn - num_effect_columns;
  by_parameter->resize(all.rows(), num_parameters);
  *by_parameter << all.leftCols(kNumParameters),
      all.middleCols(EffectSimulation::kFirstEffectColumn, num_effect_columns);
  by_start->resize(all.rows(), num_of_state + num_excesses);
  *by_start << all.middleCols(EffectSimulation::kInitialVelocityColumn, num_of_state),
      all.rightCols(num_excesses);
  for (Eigen::Index i = 0; i < num_parameters; ++i) {
    if (!of_run[static_cast<std::size_t>(i)]) continue;
    by_start->conservativeResize(Eigen::NoChange, by_start->cols() + 1);
    by_start->rightCols(1) = by_parameter->col(i);
    by_parameter->col(i).setZero();
  }
}

}  // namespace

std::vector<bool> AreOfRun(const ExtendedModel& model) {
  std::vector<bool> of_run(kNumParameters, false);
  for (const ActiveEffect& active : model.effects) {
    of_run.insert(of_run.end(), active.values.size(), active.effect->info().scope == Scope::kRun);
  }
  return of_run;
}

// Without effects too, the simulation with effects has the same model.
std::optional<SegmentRun> RunOver(const Segment& segment, const ExtendedModel& model, Dof dof) {
  EffectInputs inputs;
  inputs.dof = dof;
  inputs.command = segment.command;
  inputs.force[Index(dof)] = segment.command;
  const double from = segment.time.front();
  const auto start = FittedStart(model,
                                 inputs,
                                 {.start = from,
                                  .velocity_time = segment.time,
                                  .velocity = segment.velocity,
                                  .displacement_time = {},
                                  .displacement = {}});
  if (!start) return std::nullopt;
  EffectOutputs outputs;
  const EffectSimulation simulation(&inputs, {from, segment.time, segment.time});
  if (!simulation.RunWithSensitivities(model, *start, &outputs)) return std::nullopt;
  const std::vector<bool> of_run = AreOfRun(model);
  SegmentRun run;
  MotionDerivatives& derivatives = run.derivatives;
  TakeColumns(
      outputs.velocity_sensitivity, of_run, 1, &derivatives.by_parameter, &derivatives.by_start);
  TakeColumns(outputs.displacement_sensitivity,
              of_run,
              2,
              &derivatives.displacement_by_parameter,
              &derivatives.displacement_by_start);
  run.motion = {std::move(outputs.velocity), std::move(outputs.displacement)};
  return run;
}

}  // namespace fathom
