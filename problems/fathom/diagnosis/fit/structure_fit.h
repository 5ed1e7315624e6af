// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"
#include "fathom/noise/whitener.h"
#include "fathom/vehicle/extended_model.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A model where its generalised squared error is least.
struct StructureFit {
  bool converged = false;
  ExtendedModel model;
  std::vector<InitialState> initial;

  NoiseModel noise;
  double log_likelihood = -std::numeric_limits<double>::infinity();
  double chi_squared = std::numeric_limits<double>::infinity();  // |W (y - simulated)|^2

  Eigen::VectorXd residual;  // measured - simulated, by bins, not whitened
  RowMajorMatrix jacobian;   // not whitened
  // Of the baseline's and the effects' parameters. One that is held on its bound has the variance
  // it would have without it, NaN where these data say nothing of it, and no covariance with
  // others.
  Eigen::MatrixXd covariance;
  std::vector<bool> is_on_bound;  // of the same

  // By how much chi squared falls because sensor and water may remember anything at the start, to
  // first order, record by record: (excess / its standard deviation)^2, one for each of
  // ExcessesOf() the model.
  std::vector<double> start_gains;
};

// What its free starts take from a model's log-likelihood ratio (2 log L): each as little as BIC
// asks, which is its gain where it had better not be there, else the logarithm of the number of
// data. A model thus pays for what its records' starts need, and for nothing where they need none.
double PriceOfStarts(const TrainingData& data, const StructureFit& fit);

// Least generalised squared error from `start` under `whitener`, every parameter within its bounds
// (inertia at least data.least_inertia(), dampings at least 0, the effects' own). Levenberg and
// Marquardt's method on the normal equations; parameters that press on a bound are held there and
// let go again when they no longer do, docs/diagnosis.md (3).
//
// Ends when no step promises more than `smallest_share` of what is left of the error (or 0.01).
StructureFit FitStructure(const TrainingData& data,
                          const ExtendedModel& start,
                          std::span<const InitialState> initial,
                          const Whitener& whitener,
                          double smallest_share = 0.0);

// The same with the noise learned along: fit and noise in turns, from `noise`.
StructureFit FitStructureAndNoise(const TrainingData& data,
                                  const ExtendedModel& start,
                                  std::span<const InitialState> initial,
                                  const NoiseModel& noise);

// The same on from a fit whose residual and Jacobian are those of its model, the noise from that.
StructureFit FitStructureAndNoise(const TrainingData& data, const StructureFit& start);

// The baseline from a start near its optimum, with its noise.
StructureFit FitBaseline(const TrainingData& data,
                         const ExtendedModel& start,
                         std::span<const InitialState> initial);

// A given model from the states that fit it best, each channel weighed by what the model misses of
// it: residual and Jacobian alone, no likelihood. No Jacobian if it cannot be simulated.
StructureFit FitStates(const TrainingData& data,
                       const ExtendedModel& model,
                       std::span<const InitialState> initial);

// As if all of a residual were white: its RMS, channel by channel; at least 1e-12.
NoiseModel WhiteNoise(const TrainingData& data, const Eigen::VectorXd& residual);

// The noise of a fit's residual, of which nothing else is known.
NoiseModel FirstNoise(const TrainingData& data, const StructureFit& fit);

// White noise as a sensor alone would have it, from the residual's second differences, which
// structure hardly reaches: under it nothing that is missing passes for a disturbance.
NoiseModel SensorNoiseOnly(const TrainingData& data, const Eigen::VectorXd& residual);

}  // namespace fathom
