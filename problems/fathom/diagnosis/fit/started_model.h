// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/diagnosis/fit/structure_fit.h"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A model that runs freely over the training data: where it starts in each segment, and what it
// misses.
struct StartedModel {
  ExtendedModel model;
  Eigen::MatrixXd covariance;         // of the baseline's parameters, then the effects'
  std::vector<InitialState> initial;  // by segments
  Eigen::VectorXd residual;           // measured - simulated, by bins; empty before it has run
};

StartedModel StartedFrom(const StructureFit& fit);

// Output error's robust answer (problems/output_error), which fathom_identify would give, from a
// guess of its own; nothing if it does not converge to a physical model. The fits start here, and
// what they gain is measured against it. Its covariance is of the baseline's parameters.
std::optional<StartedModel> FindRobustStart(std::span<const MeasuredSegment> segments);

// Output error's model, as fathom_identify gives it: what the user has, and what free runs are
// judged against. (In FitBaseline() what is missing passes for noise: that fit is for weighing
// causes, and runs worse.) It starts from the states that fit it best, each channel weighed by what
// the model misses of it. Nothing if it cannot be simulated.
std::optional<StartedModel> UsersModel(const TrainingData& data, StartedModel start);

}  // namespace fathom
