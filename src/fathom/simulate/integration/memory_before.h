// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/flattened.h"
#include "fathom/simulate/integration/instants.h"
#include "fathom/simulate/integration/scalar_model.h"
#include "fathom/simulate/partner_signals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// What thrusters and water remember at the start of a run: docs/effects.md, "Before the start".

namespace fathom {

inline constexpr double kWarmUp = 60.0;  // [s] before the start, for what has a memory

template <typename T>
using ThrusterStates = std::array<T, kMostEffects>;

// The mean force of a step in which `command` is held, from `begin` on the command's clock; moves
// the thrusters' states on.
template <typename T>
FATHOM_FLATTENED T MeanForce(const EffectStack<T>& effects,
                             double command,
                             const T& begin,
                             const T& duration,
                             Instants<T>* instants,
                             ThrusterStates<T>* thrust) {
  const auto at = [&](std::size_t k) -> const Instant<T>& {
    return instants->OnCommandClock(k, T(begin + 0.5 * duration));
  };
  return effects.MeanForce(T(command), duration, at, thrust->data());
}

// The thrusters' states at `start` on the command's clock, from the command before it.
template <typename T>
ThrusterStates<T> ThrustBefore(double start,
                               const HeldCommand& command,
                               const EffectStack<T>& effects,
                               Instants<T>* instants) {
  ThrusterStates<T> thrust{};
  if (!effects.Has(&EffectLaw<T>::follow)) return thrust;
  const std::vector<double>& edges = command.time;
  const std::size_t next_edge = std::upper_bound(edges.begin(), edges.end(), start) - edges.begin();
  std::size_t first = next_edge;
  while (first > 0 && edges[first - 1] > start - kWarmUp) --first;
  if (first > 0 && first == next_edge) --first;
  const double command_before = first > 0 ? command.value[first - 1] : 0.0;
  // Long enough for any thruster to have reached what was commanded before.
  constexpr double kForEver = 1e6;
  if (first < next_edge) {
    MeanForce(effects, command_before, T(edges[first]), T(kForEver), instants, &thrust);
  }
  for (std::size_t i = first; i < next_edge; ++i) {
    const double end = i + 1 < next_edge ? edges[i + 1] : start;
    if (!(end > edges[i])) continue;
    MeanForce(effects, command.value[i], T(edges[i]), T(end - edges[i]), instants, &thrust);
  }
  return thrust;
}

// A water effect's state at `start` in log time, from the velocity measured before it; where there
// is none, in balance with the initial velocity.
template <typename T>
T MemoryBefore(double start,
               const SampledSignal& measured,
               const StackedEffect<T>& effect,
               const T& initial_velocity) {
  constexpr double kLongestStep = 0.1;  // [s]
  if (measured.time.empty() || !(measured.time.front() < start)) return initial_velocity;
  const double first = std::max(measured.time.front(), start - kWarmUp);
  const double num_steps = std::ceil((start - first) / kLongestStep);
  const double h = (start - first) / num_steps;
  std::size_t place = 0;
  T memory(LineAt(measured, first, &place).value);
  for (double i = 0.0; i < num_steps; ++i) {
    const auto rate = [&](double share, const T& at) {
      const T speed(LineAt(measured, first + h * (i + share), &place).value);
      return effect.law->memory_rate(effect.values.data(), at, speed);
    };
    const T k1 = rate(0.0, memory);
    const T k2 = rate(0.5, T(memory + 0.5 * h * k1));
    const T k3 = rate(0.5, T(memory + 0.5 * h * k2));
    const T k4 = rate(1.0, T(memory + h * k3));
    memory = memory + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return memory;
}

}  // namespace fathom
