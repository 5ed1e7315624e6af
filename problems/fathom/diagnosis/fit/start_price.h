// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// By how much chi squared falls because sensor and water may remember anything at the start, to
// first order, segment by segment: (excess / its standard deviation)^2, one for each of
// ExcessesOf() the model. `variance`: of all unknowns, as Pack() orders them.
std::vector<double> StartGainsOf(const TrainingData& data,
                                 const ExtendedModel& model,
                                 std::span<const InitialState> initial,
                                 const Eigen::VectorXd& variance);

// What free starts of these gains take from a model's log-likelihood ratio (2 log L): each as
// little as BIC asks, which is its gain where it had better not be there, else the logarithm of the
// number of data. A model thus pays for what its segments' starts need, and for nothing where they
// need none.
double PriceOfStarts(const TrainingData& data, std::span<const double> start_gains);

}  // namespace fathom
