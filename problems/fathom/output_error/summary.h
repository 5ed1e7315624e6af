// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"
#include "fathom/output_error/offset_sharing.h"
#include "fathom/output_error/parameter_covariance.h"
#include "fathom/output_error/weighting.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace fathom {

// Numbers that were not computed are NaN, never zero.
struct OutputErrorSummary {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  // True if the search converged to a physical model that the data determine.
  bool IsUsable() const { return converged && determined; }

  // Why it ended as it did, for a person.
  std::string message = "FitOutputError() was not called.";

  bool converged = false;
  bool determined = false;

  // How the answer was weighed; and why not as OutputErrorOptions asked, else empty.
  Weighting weighting = Weighting::kPlain;
  std::string weighting_reason;

  // What kLearned took the residuals for, averaged over bins as docs/output_error.md (10) says; the
  // untouched model has none.
  NoiseModel learned_noise;

  std::string initial_guess;  // "given", "least_squares", "adaptive" or "rough"
  int num_iterations = -1;    // over all passes by plain squares and the robust loss
  // Of the first pass, by plain squares, and of the last, by the robust loss with the noise level
  // found or by learned weights over bins: not to be compared with each other.
  double initial_cost = kNotComputed;
  double final_cost = kNotComputed;

  UncoupledModel<double> model = {kNotComputed, kNotComputed, kNotComputed, kNotComputed};

  // The buoyancy by OutputErrorOptions::offsets, of which the model has the mean: one, or one per
  // log. Its standard deviation is that of the fit.
  struct Offset {
    double value = kNotComputed;
    double std = kNotComputed;
  };
  std::vector<Offset> offsets;

  // The model as it acts in each of the segments.
  std::vector<UncoupledModel<double>> ModelsIn(std::size_t num_segments,
                                               const OffsetSharing& sharing) const;

  // In the order of kParameterInfo. A damping that ended on its bound 0 has the spread it would
  // have without the bound; its interval is to be cut at 0.
  ParameterCovariance covariance = ParameterCovariance::Constant(kNotComputed);
  std::array<bool, kNumParameters> on_bound = {};

  // One per segment, at its first stamp.
  std::vector<InitialState> initial_states;

  // Shares, condition number and noise at the optimum.
  ParameterEvidence evidence;

  // Fills the evidence and what follows from it: the covariance, the offsets' deviations.
  void Take(ParameterEvidence found);

  // What the reader must know beyond the intervals, a sentence each.
  std::vector<std::string> caveats;

  // One of them: these data cannot tell a delay of the command from inertia and damping.
  bool delay_is_open = false;
};

}  // namespace fathom
