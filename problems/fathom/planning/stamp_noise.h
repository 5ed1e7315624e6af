// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/autoregression.h"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace fathom {

// Standard deviations of what is measured at each stamp of a run.
struct StampNoise {
  double velocity = 1.0;  // [m/s] or [rad/s]
  // [m] or [rad], white; infinite: only velocities are measured.
  double position = std::numeric_limits<double>::infinity();

  // Of the velocity's noise, over the stamps, with stationary variance 1; of order 0: white.
  Autoregression colour = {};

  bool MeasuresPosition() const { return std::isfinite(position); }
};

// The covariance of neighbours 0, 1 ... `count` - 1 samples apart under a stable autoregression of
// these coefficients, scaled to stationary variance 1. Throws InputError where they are not stable:
// what they say of one sample has not died away after 100000.
std::vector<double> CorrelationsOf(std::span<const double> coefficients, int count);

// The autoregression of lowest order that says as much of noise fitted over `num_samples`: the one
// with the least BIC among those with its first covariances, docs/plan.md (8). AIC, by which fits
// choose their order, takes too high a one in a third of all fits, and what the terms too many say
// of slow noise is chance.
std::vector<double> PlainestColour(std::span<const double> coefficients, int num_samples);

// Noise of standard deviation `velocity` and the colour `coefficients` over samples, as the mean of
// each `num_samples` neighbours has it: a stamp stands for them. docs/plan.md (8). The colour of
// means is an autoregression of the order that the samples' has, 20 at most, with their first
// covariances.
StampNoise MeansOf(double velocity, std::span<const double> coefficients, int num_samples);

}  // namespace fathom
