// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/extended_model.h"

#include <array>
#include <functional>
#include <vector>

#include "drawn_setup.h"
#include "known_run.h"

namespace fathom::hidden {

// How large things are in a run in which nothing is hidden.
struct RunScales {
  std::array<double, 6> force{};  // RMS command, by Index(Dof)
  std::array<double, 6> speed{};  // RMS
  double most_force = 0.0;        // of the DOF
  double length = 0.0;            // RMS distance of the DOF from its mean place [m] or [rad]
  double duration = 0.0;          // [s]
  double train_duration = 0.0;    // [s]
};

RunScales ScalesOfRun(const EffectInputs& inputs, Dof dof, double train_to);

// An effect's values as a function of one size, 0 being the null and 1 about as large as what it
// acts on; signs, times, frequencies and shapes are drawn once.
struct SizedEffect {
  double largest = 1.0;  // that is physical
  std::function<std::vector<double>(double size)> values;
};

SizedEffect DrawShape(const ActiveEffect& effect,
                      const UncoupledModel<double>& baseline,
                      const RunScales& scales,
                      Chance& chance);

// How many standard deviations the effect stands out of a noiseless run of `baseline`: what the
// baseline, fitted to that run, cannot imitate |W (y - y_fitted)| [-]. `run` pretends to be another
// one afterwards. Infinity if the run diverges.
double SignatureOf(const UncoupledModel<double>& baseline,
                   const InitialState& initial,
                   const ActiveEffect& effect,
                   KnownRun* run);

// Sets effect->values so that its signature is `wanted`, within the physical sizes. Returns the
// signature.
double SizeFor(double wanted,
               const UncoupledModel<double>& baseline,
               const InitialState& initial,
               const SizedEffect& sized,
               KnownRun* run,
               ActiveEffect* effect);

}  // namespace fathom::hidden
