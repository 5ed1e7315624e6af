// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"
#include "fathom/output_error/learned/binned_run.h"
#include "fathom/output_error/learned/binned_segment.h"
#include "fathom/output_error/options.h"
#include "fathom/output_error/summary.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// Output error weighed by the noise that it learns along, docs/output_error.md (10), (11).
struct LearnedFit {
  bool converged = false;
  std::string message;                       // why not
  UncoupledModel<double> model;              // with the mean of the offsets
  std::vector<double> offsets;               // as in OutputErrorSummary
  std::vector<InitialState> initial_states;  // by segment
  std::vector<int> held;                     // dampings on their bound
  NoiseModel noise;                          // of the bins
  std::vector<BinnedRun> runs;               // by segment, there; whitened
};

// Noise and model in turns, on from a `plain` fit of the same segments.
LearnedFit FitLearned(std::span<const BinnedSegment> bins,
                      const OutputErrorSummary& plain,
                      const OutputErrorOptions& options);

}  // namespace fathom
