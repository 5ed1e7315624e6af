// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"
#include "fathom/diagnosis/fit/criterion.h"
#include "fathom/noise/whitener.h"
#include "fathom/vehicle/extended_model.h"

#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A model where its generalised squared error is least. All members belong to this one fit.
struct StructureFit {
  bool converged = false;  // false: it stopped before it arrived
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

  std::vector<double> start_gains;  // StartGainsOf() it

  // False where the model cannot be simulated: then there is no Jacobian either.
  bool IsSimulated() const { return jacobian.size() > 0; }

  // False where it must not be compared with others, since it says nothing of how good its model
  // is.
  bool IsUsable() const { return IsSimulated() && converged; }
};

// Least generalised squared error from `start` under `whitener`, every parameter within its bounds
// (inertia at least data.least_inertia(), dampings at least 0, the effects' own). Levenberg and
// Marquardt's method on the normal equations; parameters that press on a bound are held there and
// let go again when they no longer do, docs/diagnosis.md (3).
StructureFit FitStructure(const TrainingData& data,
                          const ExtendedModel& start,
                          std::span<const InitialState> initial,
                          const Whitener& whitener,
                          const FitPrecision& precision = {});

// The same on from a fit whose residual and Jacobian are those of its model.
StructureFit FitStructure(const TrainingData& data,
                          StructureFit start,
                          const Whitener& whitener,
                          const FitPrecision& precision = {});

}  // namespace fathom
