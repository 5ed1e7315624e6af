// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// What the velocity sensor shows at the stamps of `segment` in a free run from `initial`, which
// holds at the first stamp: the measurement never enters. Nothing if the simulation diverges.
//
// By EffectSimulation, whose inputs are the log's; without effects `inputs` may be null, and the
// segment's command is all that it takes.
std::optional<std::vector<double>> Predict(const ExtendedModel& model,
                                           const Segment& segment,
                                           const InitialState& initial,
                                           const EffectInputs* inputs = nullptr);

// MAE and NMAE over several runs together (paper Eqs. 10 and 11).
class FigureSums {
 public:
  // One run: velocities [m/s] or [rad/s] at the stamps `time` [s], all of one length.
  void Add(std::span<const double> time,
           std::span<const double> measured,
           std::span<const double> predicted);

  // The figures are NaN if nothing was added; NMAE also if nothing ever moved.
  FitFigures Figures() const;

 private:
  double sum_of_errors_ = 0.0, sum_of_speeds_ = 0.0, duration_ = 0.0;
  int num_samples_ = 0;
};

}  // namespace fathom
