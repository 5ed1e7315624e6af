// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/window_problem.h"

#include <vector>

#include <Eigen/Core>

namespace fathom {

// What each weighed row adds to the gradient, with the starts eliminated, summed over blocks of
// time. The blocks' scatter tells how sure the entries are, whatever colour is left.
struct WindowScores {
  Eigen::MatrixXd by_block;  // a row for each
  Eigen::MatrixXd normal;    // of the entries, after the starts
};

// `block`: its length [s]. False if a run diverges.
bool ScoresOf(const WindowProblem& problem,
              const std::vector<ChannelWeight>& weights,
              const WindowPoint& point,
              double block,
              WindowScores* scores);

}  // namespace fathom
