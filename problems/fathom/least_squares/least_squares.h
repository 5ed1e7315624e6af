// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

struct LeastSquaresOptions {
  // A combination of the four columns (each scaled to length 1) is not determined if its singular
  // value is below this share of the largest. Above 0, below 1.
  double smallest_singular_value = 1e-8;

  // Highest order of the autoregression that stands for the colour of the residuals. At least 0.
  int max_noise_order = 60;

  // Every broken rule, a sentence each; empty if the options can be used.
  std::vector<std::string> Problems() const;
};

// What FitLeastSquares found. Numbers that were not computed are NaN.
struct LeastSquaresSummary {
  bool usable = false;
  std::string message = "FitLeastSquares was not called.";

  UncoupledModel<double> model{std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN()};

  // Of the parameters, in the order of kParameterInfo.
  ParameterCovariance covariance =
      ParameterCovariance::Constant(std::numeric_limits<double>::quiet_NaN());

  // Largest over smallest singular value of the columns scaled to length 1.
  double condition_number = std::numeric_limits<double>::quiet_NaN();

  bool has_wrong_sign = false;  // the inertia would be negative, by its whole 95 % interval
  int num_samples = 0;          // that entered the fit
  std::vector<std::string> not_determined;  // names of parameters that the data leave open
  std::vector<std::string> caveats;         // what the intervals do not cover, a sentence each

  bool IsUsable() const { return usable; }
};

// Equation-error least squares (the paper's Eqs. 3-6) over all `segments` together.
//
//   dv/dt = alpha tau + beta v|v| + mu v + nu                  docs/least_squares.md (1)
//   m = 1/alpha, d_Q = -beta/alpha, d_L = -mu/alpha, b = -nu/alpha                  (2)
//
// by a singular value decomposition of the columns scaled to length 1. Both sides are the segments'
// acceleration, smoothed_velocity and smoothed_force; samples where one of them is NaN are left
// out.
//
// The covariance holds for residuals coloured like an autoregression, as Savitzky-Golay derivatives
// are. It takes tau and v as exact: their noise biases the answer, and no interval here covers
// that.
//
// Not usable: too few samples, a rank-deficient regressor, an inertia that is not positive, or one
// whose inverse alpha is not distinguishable from 0. Throws InputError for options that break their
// rules.
LeastSquaresSummary FitLeastSquares(std::span<const Segment> segments,
                                    const LeastSquaresOptions& options = {});

}  // namespace fathom
