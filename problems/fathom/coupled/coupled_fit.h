// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/entry_prior.h"
#include "fathom/coupled/fitted_channel.h"
#include "fathom/coupled/row_whitener.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/motion_structure.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What a fit took the residuals of one channel for.
struct ChannelNoise {
  FittedChannel channel;
  RowWhitener whitener;
};

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

// Numbers that were not computed are NaN, never zero.
struct CoupledSummary {
  // True if the search converged to a model that the data determine.
  bool IsUsable() const { return converged && determined; }

  std::string message = "FitCoupled() was not called.";
  bool converged = false;
  bool determined = false;

  CoupledModel model;
  std::vector<FreeEntry> entries;
  Eigen::MatrixXd covariance;            // of the entries, in their order
  std::vector<FreeEntry> on_bound;       // pressed against what keeps the model physical
  std::vector<FreeEntry> open_inertias;  // of a DOF, that may be 0 as far as the data tell
  std::vector<FreeEntry>
      undetermined;  // that trade against each other without a trace, or may be 0

  std::vector<EntryPrior> priors;  // that held entries which the data leave open

  std::vector<CoupledState> starts;  // of the windows, in their order
  std::vector<ChannelNoise> noise;
  double cost = std::numeric_limits<double>::quiet_NaN();  // half the sum of weighed squares
  int num_rows = 0;
  int num_iterations = 0;
};

// The numbers of a structure with which free runs of all `logs`, window by window, come nearest to
// what was measured: output error with each channel's own coloured noise, docs/coupled.md. Held-out
// segments are left alone.
//
// Throws InputError if options.Problems() is not empty. A poor fit does not throw: see the summary.
CoupledSummary FitCoupled(std::span<const CoupledData> logs,
                          const MotionStructure& structure,
                          const CoupledFitOptions& options = {});

}  // namespace fathom
