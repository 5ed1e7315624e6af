// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/robust_start.h"
#include "fathom/diagnosis/fit/structure_fit.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A model that runs freely over the training data: where it starts in each segment, and what it
// misses.
struct StartedModel {
  ExtendedModel model;
  Eigen::MatrixXd covariance;         // of the baseline's parameters, then the effects'
  std::vector<InitialState> initial;  // by segments
  Eigen::VectorXd residual;           // measured - simulated, by bins
};

StartedModel StartedFrom(const StructureFit& fit);

// Output error's model, as fathom_identify gives it: what the user has, and what free runs are
// judged against. (In FitBaseline() what is missing passes for noise: that fit is for weighing
// causes, and runs worse.) It starts from the states that fit it best, each channel weighed by what
// the model misses of it. Nothing if it cannot be simulated.
std::optional<StartedModel> UsersModel(const TrainingData& data, const RobustStart& start);

}  // namespace fathom
