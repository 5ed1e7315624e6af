// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/vehicle/fitted_model.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// The velocity that `model` predicts at the stamps of `segment` from its command alone, started
// from `initial_velocity` [m/s] or [rad/s]: a free run, the measurement never enters. Nothing if
// the simulation diverges.
std::optional<std::vector<double>> PredictVelocity(const UncoupledModel<double>& model,
                                                   const Segment& segment,
                                                   double initial_velocity);

// Where a free run over a segment starts: its initial_velocity, or where that is not known its
// first measured velocity.
double InitialVelocity(const Segment& segment);

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

// Of the free runs over all `segments`, each started from its InitialVelocity(). All NaN if a run
// diverges.
FitFigures FiguresOf(const UncoupledModel<double>& model, std::span<const Segment> segments);

}  // namespace fathom
