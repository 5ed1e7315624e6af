// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/extended_model.h"

#include <limits>

#include "known_run.h"

namespace fathom::hidden {

// A model fitted to a run whose noise is known.
struct KnownNoiseFit {
  bool converged = false;
  ExtendedModel model;
  InitialState initial;
  double chi2 = std::numeric_limits<double>::infinity();  // whitened sum of squares
  int num_effect_parameters = 0;
};

struct KnownNoiseFitOptions {
  int max_iterations = 30;

  // The search gives up early where it can no longer come below this: at a point whose linear
  // forecast stays above.
  double wanted_chi2 = std::numeric_limits<double>::infinity();

  bool start_only = false;  // only the start (velocity, and position if it matters) is fitted
};

// Levenberg and Marquardt from `start`, all parameters within their bounds.
KnownNoiseFit FitWithKnownNoise(const KnownRun& run,
                                const ExtendedModel& start,
                                const InitialState& initial,
                                const KnownNoiseFitOptions& options = {});

}  // namespace fathom::hidden
