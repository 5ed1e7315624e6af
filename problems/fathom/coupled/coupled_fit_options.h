// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_summary.h"
#include "fathom/coupled/entry_prior.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// How FitCoupled() fits.
struct CoupledFitOptions {
  // Motion is simulated from a free start anew after so long [s], above 0. A short window forgives
  // a disturbance and an unstable vehicle; a long one holds slow motion to the model.
  double window = 20.0;

  // From how many standard deviations on a residual counts linearly. Above 0.
  double huber_k = 3.0;

  // The body alone: the inertia less this stays positive definite, where it is known.
  RigidBody body;

  // The numbers that are not free.
  CoupledModel held;

  // Where the search begins; absent: MomentumStart().
  std::optional<CoupledModel> start;

  // Those of the windows there, as another fit of the same windows found them. Of another number,
  // or empty: as measured.
  std::vector<CoupledState> window_starts;

  // What is known before any data.
  std::vector<EntryPrior> priors;

  // What the residuals are taken for at first, as another fit found them. Of other channels than
  // this fit's, or empty: white noise, whose colour is then learned.
  std::vector<ChannelNoise> noise;

  // Of a noise that is given: false leaves it as it is, and computes no covariance. For many fits
  // of parts of the same data.
  bool learns_noise = true;

  int max_iterations = 60;  // of each pass, above 0

  // One line for each rule that is broken; empty if these options can be used.
  std::vector<std::string> Problems() const;
};

// The same from where another fit has ended: its model, noise and priors.
CoupledFitOptions BegunAt(const CoupledSummary& fit, CoupledFitOptions options);

}  // namespace fathom
