// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/unknowns.h"

#include "fathom/diagnosis/fit/parameter_bounds.h"
#include "fathom/vehicle/parameters.h"

#include <limits>

namespace fathom {

Unknowns Pack(const TrainingData& data,
              const ExtendedModel& model,
              std::span<const InitialState> initial) {
  const int num_parameters = EffectSimulation::NumParameters(model);
  const int size = num_parameters + data.num_states(model) * static_cast<int>(initial.size());
  const std::vector<Excess> excesses = EffectSimulation::ExcessesOf(model);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Unknowns unknowns = {Eigen::VectorXd(size),
                       Eigen::VectorXd::Constant(size, -kInfinity),
                       Eigen::VectorXd::Constant(size, kInfinity)};
  unknowns.value.head<kNumParameters>() = ToVector(model.baseline);
  unknowns.lower[kInertia] = data.least_inertia();
  unknowns.lower[kQuadraticDamping] = unknowns.lower[kLinearDamping] = 0.0;
  int i = kNumParameters;
  for (const ActiveEffect& active : model.effects) {
    for (size_t k = 0; k < active.values.size(); ++k, ++i) {
      const EffectParameter& parameter = active.effect->info().parameters[k];
      unknowns.value[i] = active.values[k];
      const auto [lower, upper] = BoundsOf(parameter, data);
      unknowns.lower[i] = lower;
      unknowns.upper[i] = upper;
    }
  }
  for (const InitialState& state : initial) {
    unknowns.value[i++] = state.velocity;
    if (data.has_displacement()) unknowns.value[i++] = state.position;
    for (const Excess excess : excesses) unknowns.value[i++] = state.*excess;
  }
  return unknowns;
}

void Unpack(const TrainingData& data,
            const Eigen::VectorXd& value,
            ExtendedModel* model,
            std::vector<InitialState>* initial) {
  model->baseline = ModelFromVector(value.head<kNumParameters>());
  int i = kNumParameters;
  for (ActiveEffect& active : model->effects) {
    for (double& number : active.values) number = value[i++];
  }
  const std::vector<Excess> excesses = EffectSimulation::ExcessesOf(*model);
  for (InitialState& state : *initial) {
    const double velocity = value[i++];
    state = {velocity, data.has_displacement() ? value[i++] : state.position};
    for (const Excess excess : excesses) state.*excess = value[i++];
  }
}

std::vector<int> FreeOf(const Unknowns& unknowns, const Eigen::VectorXd& downhill) {
  std::vector<int> free;
  for (int i = 0; i < unknowns.value.size(); ++i) {
    const bool presses_low = unknowns.value[i] <= unknowns.lower[i] && downhill[i] <= 0.0;
    const bool presses_high = unknowns.value[i] >= unknowns.upper[i] && downhill[i] >= 0.0;
    if (!presses_low && !presses_high) free.push_back(i);
  }
  return free;
}

}  // namespace fathom
