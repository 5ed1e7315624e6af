// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/flattened.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/integration/memory_before.h"
#include "fathom/simulate/integration/run_step.h"
#include "fathom/simulate/integration/shown_displacements.h"
#include "fathom/simulate/integration/shown_readings.h"
#include "fathom/simulate/integration/step_pace.h"
#include "fathom/simulate/integration/water_integrator.h"
#include "fathom/simulate/output_stamps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

// The integration behind EffectSimulation, for one scalar. Not for other includers.

namespace fathom {

// Where a run begins, at `start` in log time [s].
template <typename T>
RunState<T> FirstState(const EffectInputs& inputs, const ScalarModel<T>& model, double start) {
  RunState<T> state;
  state.velocity = model.initial_velocity;
  state.position = model.initial_position;
  if (!model.effects.Has(&EffectLaw<T>::memory_rate)) return state;
  state.memory.resize(model.effects.size());
  for (std::size_t k = 0; k < model.effects.size(); ++k) {
    if (model.effects[k].law->memory_rate == nullptr) continue;
    state.memory[k] =
        MemoryBefore(
            start, inputs.velocity[Index(inputs.dof)], model.effects[k], model.initial_velocity) +
        model.initial_memory_excess;
  }
  return state;
}

enum class Scheme { kClassical, kMidpoint, kStiff };

// Takes a step whose ends and force are known. The first one alone may have a length with
// derivatives.
template <typename T>
void Take(Scheme scheme, bool is_first, double rate, WaterIntegrator<T>* water, RunStep<T>* step) {
  const auto take = [&](const auto& h) {
    step->stiff_rate = 0.0;
    if (scheme == Scheme::kClassical) {
      water->Step(step->before, step->force, step->begin, h, &step->slope, &step->after);
    } else if (scheme == Scheme::kMidpoint) {
      water->MidpointStep(step->before, step->force, step->begin, h, &step->slope, &step->after);
    } else if (water->StiffStep(
                   step->before, step->force, step->begin, h, rate, &step->slope, &step->after)) {
      step->stiff_rate = rate;
    }
  };
  if (is_first) {
    take(step->duration);
  } else {
    take(Value(step->duration));
  }
}

// Puts the end of the next step at most `longest` [s] on, on an even way to the command's `edge`,
// with the force over it. True if it ends at the edge.
template <typename T>
bool SetEnd(const EffectStack<T>& effects,
            double edge,
            double longest,
            bool is_first,
            Instants<T>* instants,
            RunStep<T>* step) {
  const double s = Value(step->begin);
  const double num_steps = std::max(1.0, std::ceil((edge - s) / longest * (1.0 - 1e-9)));
  const bool reaches_edge = num_steps == 1.0;
  step->end = reaches_edge ? edge : s + (edge - s) / num_steps;
  step->duration = is_first ? T(T(step->end) - step->begin) : T(step->end - s);
  instants->held_time = s + 0.5 * Value(step->duration) + Value(instants->delay());
  step->thrust_after = step->thrust;
  step->force =
      MeanForce(effects, step->command, step->begin, step->duration, instants, &step->thrust_after);
  return reaches_edge;
}

// How long a stiff step may be, from one to the next.
struct StiffLength {
  double longest = 0.1;  // [s]
  int repeats_left = 0;  // of steps that were too long
};

// A stiff step, halved until it is short enough. True if it ends at the edge; nothing if there are
// no repeats left.
template <typename T>
std::optional<bool> TakeStiff(const EffectStack<T>& effects,
                              double edge,
                              double longest,
                              bool is_first,
                              Instants<T>* instants,
                              WaterIntegrator<T>* water,
                              StepPace* pace,
                              StiffLength* length,
                              RunStep<T>* step) {
  const double s = Value(step->begin);
  const RunState<double> before = ValuesOf(step->before);
  const double rate = pace->SpeedRate(before, before.velocity, step->command, s);
  length->longest = std::min(2.0 * length->longest, longest);
  for (; length->repeats_left > 0; --length->repeats_left) {
    const bool reaches_edge = SetEnd(effects, edge, length->longest, is_first, instants, step);
    Take(Scheme::kStiff, is_first, rate, water, step);
    const double slope = Value(step->slope.velocity);
    const double h = Value(step->duration);
    const double force = Value(step->force);
    if (pace->IsShortEnough(before, slope, ValuesOf(step->after), force, s, h, rate)) {
      return reaches_edge;
    }
    length->longest = 0.5 * h;
  }
  return std::nullopt;
}

// One run of `model`, of which `numbers` has the same numbers without derivatives. Calls
// emit_velocity(row, reading) and emit_displacement(row, reading) at every output stamp; false if
// the state diverges or is too stiff. `num_steps`: how many it took. All times of the steps are on
// the command's clock, s = t - delay of the command: the steps then never move, and only the
// outputs do.
template <typename T, typename EmitVelocity, typename EmitDisplacement>
FATHOM_FLATTENED bool IntegrateWithEffects(const EffectInputs& inputs,
                                           const ScalarModel<T>& model,
                                           const ScalarModel<double>& numbers,
                                           const OutputStamps& stamps,
                                           const EmitVelocity& emit_velocity,
                                           const EmitDisplacement& emit_displacement,
                                           int* num_steps) {
  constexpr double kLargestSpeed = 1e6;   // [m/s] or [rad/s]; beyond, it has diverged
  constexpr double kMostRepeats = 200.0;  // of stiff steps, per second
  *num_steps = 0;
  Instants<T> instants(inputs, model.effects);
  StepPace pace(inputs, numbers);
  WaterIntegrator<T> water(model, !stamps.displacement.empty(), &instants);
  ShownReadings<T> readings(model, stamps.start, stamps.velocity, &instants);
  ShownDisplacements<T> displacements(model, stamps.displacement, &instants);

  const std::vector<double>& edges = inputs.command.time;
  RunStep<T> step;
  step.begin = stamps.start - instants.delay();
  step.after = FirstState(inputs, model, stamps.start);
  step.slope.memory.resize(step.after.memory.size());
  RunState<double> state;
  step.thrust_after = ThrustBefore(Value(step.begin), inputs.command, model.effects, &instants);
  std::size_t next_edge =
      std::upper_bound(edges.begin(), edges.end(), Value(step.begin)) - edges.begin();
  StiffLength stiff = {
      .repeats_left = 1000 + static_cast<int>(std::min(1e9, kMostRepeats * stamps.Duration()))};
  for (bool is_first = true; !readings.empty() || !displacements.empty(); is_first = false) {
    ++*num_steps;
    const double s = Value(step.begin);
    step.command = next_edge > 0 ? inputs.command.value[next_edge - 1] : 0.0;
    const double edge = next_edge < edges.size() ? edges[next_edge] : s + 1.0;
    SetValues(step.after, &state);
    const auto [longest, rate, is_stiff] = pace.From(state, step.command, s, edge - s);
    if (longest == 0.0) return false;
    step.thrust = step.thrust_after;
    step.before = step.after;
    bool reaches_edge = false;
    if (is_stiff) {
      const auto taken = TakeStiff(
          model.effects, edge, longest, is_first, &instants, &water, &pace, &stiff, &step);
      if (!taken) return false;
      reaches_edge = *taken;
    } else {
      reaches_edge = SetEnd(model.effects, edge, longest, is_first, &instants, &step);
      const bool is_slow = rate * Value(step.duration) < inputs.steps.midpoint;
      Take(is_slow ? Scheme::kMidpoint : Scheme::kClassical, is_first, 0.0, &water, &step);
    }
    if (!(std::abs(Value(step.after.velocity)) < kLargestSpeed)) return false;

    readings.Pass(step, &water, emit_velocity);
    displacements.Pass(step, emit_displacement);
    step.begin = T(step.end);
    if (reaches_edge) ++next_edge;
  }
  return true;
}

}  // namespace fathom
