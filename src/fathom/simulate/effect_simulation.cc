// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/effect_simulation.h"

#include "fathom/base/tiny_as_zero.h"
#include "fathom/simulate/integration/integrate_with_effects.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <string>
#include <utility>

#include <ceres/jet.h>
#include <glog/logging.h>

namespace fathom {
namespace {

template <typename T>
T Seeded(double value, int column) {
  if constexpr (std::is_same_v<T, double>) {
    return value;
  } else {
    return T(value, column);
  }
}

// The model's numbers as scalars, each its own direction of differentiation. What acts in another
// log alone keeps its directions and is otherwise not there.
template <typename T>
ScalarModel<T> InScalars(const ExtendedModel& model,
                         const InitialState& initial,
                         const std::string& log) {
  ScalarModel<T> scalars;
  scalars.baseline = {Seeded<T>(model.baseline.inertia, kInertia),
                      Seeded<T>(model.baseline.quadratic_damping, kQuadraticDamping),
                      Seeded<T>(model.baseline.linear_damping, kLinearDamping),
                      Seeded<T>(model.baseline.buoyancy, kBuoyancy)};
  scalars.initial_velocity = Seeded<T>(initial.velocity, EffectSimulation::kInitialVelocityColumn);
  scalars.initial_position = Seeded<T>(initial.position, EffectSimulation::kInitialPositionColumn);
  std::vector<StackedEffect<T>> effects;
  int column = EffectSimulation::kFirstEffectColumn;
  for (const ActiveEffect& active : model.effects) {
    if (!active.setting.ActsIn(log)) {
      column += static_cast<int>(active.values.size());
      continue;
    }
    const EffectInfo& info = active.effect->info();
    CHECK_EQ(active.values.size(), info.parameters.size());
    StackedEffect<T> effect = {&active.effect->law<T>(), active.setting, info.has_partner(), {}};
    scalars.depends_on_time = scalars.depends_on_time || info.depends_on_time;
    for (const double value : active.values) effect.values.push_back(Seeded<T>(value, column++));
    effects.push_back(std::move(effect));
  }
  scalars.effects = EffectStack<T>(std::move(effects));
  for (const Excess excess : EffectSimulation::ExcessesOf(model)) {
    (excess == &InitialState::reading_excess ? scalars.initial_reading_excess
                                             : scalars.initial_memory_excess) =
        Seeded<T>(initial.*excess, column++);
  }
  return scalars;
}

template <typename T>
bool RunIn(const EffectInputs& inputs,
           const OutputStamps& stamps,
           const ExtendedModel& model,
           const InitialState& initial,
           EffectOutputs* outputs) {
  CHECK_LE(model.effects.size(), kMostEffects);
  outputs->velocity.resize(stamps.velocity.size());
  outputs->displacement.resize(stamps.displacement.size());
  if constexpr (!std::is_same_v<T, double>) {
    const int num_columns = EffectSimulation::NumColumns(model);
    outputs->velocity_sensitivity.resize(static_cast<Eigen::Index>(stamps.velocity.size()),
                                         num_columns);
    outputs->displacement_sensitivity.resize(static_cast<Eigen::Index>(stamps.displacement.size()),
                                             num_columns);
  }
  const auto store = [](const T& value, size_t row, std::vector<double>* values, auto* matrix) {
    if constexpr (std::is_same_v<T, double>) {
      (*values)[row] = value;
    } else {
      (*values)[row] = value.a;
      const auto i = static_cast<Eigen::Index>(row);
      matrix->row(i) = value.v.head(matrix->cols()).transpose();
    }
  };
  return IntegrateWithEffects(
      inputs,
      InScalars<T>(model, initial, inputs.log),
      InScalars<double>(model, initial, inputs.log),
      stamps,
      [&](size_t row, const T& value) {
        store(value, row, &outputs->velocity, &outputs->velocity_sensitivity);
      },
      [&](size_t row, const T& value) {
        store(value, row, &outputs->displacement, &outputs->displacement_sensitivity);
      },
      &outputs->num_steps);
}

}  // namespace

int EffectSimulation::NumColumns(const ExtendedModel& model) {
  return NumParameters(model) + kFirstEffectColumn - kNumParameters +
         static_cast<int>(ExcessesOf(model).size());
}

int EffectSimulation::NumParameters(const ExtendedModel& model) {
  size_t num_parameters = kNumParameters;
  for (const ActiveEffect& active : model.effects) num_parameters += active.values.size();
  return static_cast<int>(num_parameters);
}

bool EffectSimulation::HasReadingMemory(const ExtendedModel& model) {
  return std::any_of(model.effects.begin(), model.effects.end(), [](const ActiveEffect& active) {
    return active.effect->law<double>().follow_reading != nullptr;
  });
}

std::vector<Excess> EffectSimulation::ExcessesOf(const ExtendedModel& model) {
  std::vector<Excess> excesses;
  if (HasReadingMemory(model)) excesses.push_back(&InitialState::reading_excess);
  const bool has_memory =
      std::any_of(model.effects.begin(), model.effects.end(), [](const ActiveEffect& active) {
        return active.effect->law<double>().memory_rate != nullptr;
      });
  if (has_memory) excesses.push_back(&InitialState::memory_excess);
  return excesses;
}

EffectSimulation::EffectSimulation(const EffectInputs* inputs, OutputStamps stamps)
    : inputs_(inputs), stamps_(std::move(stamps)) {
  CHECK(!stamps_.velocity.empty() || !stamps_.displacement.empty());
  CHECK_EQ(inputs->command.time.size(), inputs->command.value.size());
}

bool EffectSimulation::Run(const ExtendedModel& model,
                           const InitialState& initial,
                           EffectOutputs* outputs) const {
  return RunIn<double>(*inputs_, stamps_, model, initial, outputs);
}

bool EffectSimulation::RunWithSensitivities(const ExtendedModel& model,
                                            const InitialState& initial,
                                            EffectOutputs* outputs) const {
  const TinyAsZero tiny_as_zero;
  const int num_columns = NumColumns(model);
  CHECK_LE(num_columns, kFirstEffectColumn + kMostEffectParameters);
  return num_columns <= 8 ? RunIn<SmallJet>(*inputs_, stamps_, model, initial, outputs)
                          : RunIn<LargeJet>(*inputs_, stamps_, model, initial, outputs);
}

}  // namespace fathom
