// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/flown_information.h"

#include "fathom/base/input_error.h"
#include "fathom/planning/information.h"
#include "fathom/simulate/effect_simulation.h"
#include "fathom/simulate/fitted_start.h"
#include "fathom/vehicle/parameters.h"

#include <fmt/format.h>

namespace fathom {
namespace {

// True for each parameter that belongs to one run.
std::vector<bool> AreOfRun(const ExtendedModel& model) {
  std::vector<bool> of_run(kNumParameters, false);
  for (const ActiveEffect& active : model.effects) {
    of_run.insert(of_run.end(), active.values.size(), active.effect->info().scope == Scope::kRun);
  }
  return of_run;
}

// Without effects too, the simulation with effects has the same model.
std::optional<MotionDerivatives> DerivativesOver(const Segment& segment,
                                                 const ExtendedModel& model,
                                                 Dof dof) {
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
  const EffectSimulation simulation(&inputs, {from, segment.time, {}});
  if (!simulation.RunWithSensitivities(model, *start, &outputs)) return std::nullopt;

  // Columns: the baseline's, the state at the start, the effects', the rest of the start.
  const SensitivityMatrix& all = outputs.velocity_sensitivity;
  const std::vector<bool> of_run = AreOfRun(model);
  const auto num_parameters = static_cast<Eigen::Index>(of_run.size());
  const Eigen::Index num_effect_columns = num_parameters - kNumParameters;
  const Eigen::Index num_excesses =
      all.cols() - EffectSimulation::kFirstEffectColumn - num_effect_columns;
  MotionDerivatives derivatives;
  derivatives.by_parameter.resize(all.rows(), num_parameters);
  derivatives.by_parameter << all.leftCols(kNumParameters),
      all.middleCols(EffectSimulation::kFirstEffectColumn, num_effect_columns);
  derivatives.by_start.resize(all.rows(), 1 + num_excesses);
  derivatives.by_start << all.col(EffectSimulation::kInitialVelocityColumn),
      all.rightCols(num_excesses);
  for (Eigen::Index i = 0; i < num_parameters; ++i) {
    if (!of_run[static_cast<std::size_t>(i)]) continue;
    derivatives.by_start.conservativeResize(Eigen::NoChange, derivatives.by_start.cols() + 1);
    derivatives.by_start.rightCols(1) = derivatives.by_parameter.col(i);
    derivatives.by_parameter.col(i).setZero();
  }
  return derivatives;
}

}  // namespace

Eigen::MatrixXd FlownInformation(const FittedModel& model,
                                 const std::vector<Segment>& flown,
                                 const StampNoise& noise,
                                 const std::string& name) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(model.covariance.rows(), model.covariance.cols());
  for (const Segment& segment : flown) {
    const auto derivatives = DerivativesOver(segment, model.Extended(), model.dof);
    if (!derivatives) {
      throw InputError(fmt::format(
          "--log: {} diverges over the log from t = {:g} s, expected a model of the same vehicle.",
          name,
          segment.time.front()));
    }
    sum += InformationOf(*derivatives, noise);
  }
  return sum;
}

Eigen::MatrixXd FlownInformation(const PlanRequest& request) {
  return FlownInformation(request.model,
                          request.flown,
                          MeansOf(MeasurementOf(request).noise, ColourOf(request), 1),
                          request.name);
}

}  // namespace fathom
