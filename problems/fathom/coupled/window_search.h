// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/window_problem.h"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The weighed squares about a point, with the starts eliminated: half their sum, and what a small
// step of the entries changes.
struct ReducedWindows {
  double cost = 0.0;         // without the barrier
  Eigen::MatrixXd normal;    // of the entries, after the starts
  Eigen::VectorXd gradient;  // likewise
  int num_rows = 0;
};

struct WindowSearch {
  bool converged = false;
  std::string message;
  WindowPoint point;
  ReducedWindows at;  // the point
  int num_iterations = 0;
};

// The least weighed squares by Levenberg and Marquardt's steps, within the bounds of
// PhysicalBarrier. `precision`: of the step left to go, in standard deviations.
WindowSearch SearchWindows(const WindowProblem& problem,
                           const std::vector<ChannelWeight>& weights,
                           const WindowPoint& start,
                           int max_iterations,
                           double precision);

}  // namespace fathom
