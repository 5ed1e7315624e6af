// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// All that a fit looks for in one vector, with its bounds: parameters of the baseline and the
// effects, then the free states segment by segment (TrainingData::num_states()).
struct Unknowns {
  Eigen::VectorXd value, lower, upper;
};

// Inertia at least data.least_inertia(), dampings at least 0, the effects' own bounds; states are
// free.
Unknowns Pack(const TrainingData& data,
              const ExtendedModel& model,
              std::span<const InitialState> initial);

// Writes the values back into a model and its states.
void Unpack(const TrainingData& data,
            const Eigen::VectorXd& value,
            ExtendedModel* model,
            std::vector<InitialState>* initial);

// Indices of those that do not press on a bound, where `downhill` is the way to less error.
std::vector<int> FreeOf(const Unknowns& unknowns, const Eigen::VectorXd& downhill);

}  // namespace fathom
