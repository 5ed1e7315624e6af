// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/parameter_covariance.h"
#include "fathom/output_error/shooting_window.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/parameters.h"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

struct OutputErrorOptions {
  // Where the search starts. Absent: the better of least squares and, where that is poor, the
  // adaptive law, by their free-running error on the same data.
  std::optional<UncoupledModel<double>> initial_guess;

  // What the simulation is compared with; the position needs poses.
  FittedOutput output = FittedOutput::kVelocity;

  // Residuals beyond this many robust standard deviations count linearly, not squared. Above 0;
  // infinite: plain least squares.
  double huber_k = 3.0;

  // A segment longer than this is cut into windows of this length, each with an initial state of
  // its own, tied to its neighbour [s]. Above 0; infinite: single shooting.
  double shooting_window = 600.0;

  // How exactly a window must meet its neighbour: standard deviation of the jump, in standard
  // deviations of the measurement. Above 0.
  double continuity = 1e-3;

  // Above 0.
  int max_iterations = 100;

  // One line for each rule that is broken; empty if these options can be used.
  std::vector<std::string> Problems() const;
};

// Numbers that were not computed are NaN, never zero.
struct OutputErrorSummary {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  // True if the search converged to a physical model that the data determine.
  bool IsUsable() const { return converged && determined; }

  // Why it ended as it did, for a person.
  std::string message = "FitOutputError() was not called.";

  bool converged = false;
  bool determined = false;
  std::string initial_guess;  // "given", "least_squares", "adaptive" or "rough"
  int num_iterations = -1;    // over all passes
  // Of the first pass, by plain squares, and of the last, by the robust loss with the noise level
  // found: not to be compared with each other.
  double initial_cost = kNotComputed;
  double final_cost = kNotComputed;

  UncoupledModel<double> model = {kNotComputed, kNotComputed, kNotComputed, kNotComputed};

  // In the order of kParameterInfo. A damping that ended on its bound 0 has the spread it would
  // have without the bound; its interval is to be cut at 0.
  ParameterCovariance covariance = ParameterCovariance::Constant(kNotComputed);
  std::array<bool, kNumParameters> on_bound = {};

  // One per segment, at its first stamp.
  std::vector<InitialState> initial_states;

  // Shares, condition number and noise at the optimum.
  ParameterEvidence evidence;

  // What the reader must know beyond the intervals, a sentence each.
  std::vector<std::string> caveats;
};

// Parameters and initial states for which the free-running simulation of all `segments` (of one log
// or several) comes closest to what was measured; docs/output_error.md. Inertia is positive, both
// dampings at least 0.
//
// Throws InputError if options.Problems() is not empty or the segments lack the asked output. A
// poor fit does not throw: see the summary.
OutputErrorSummary FitOutputError(std::span<const Segment> segments,
                                  const OutputErrorOptions& options = {});

}  // namespace fathom
