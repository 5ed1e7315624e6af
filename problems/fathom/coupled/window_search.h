// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/window_problem.h"

#include <cstddef>
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

struct WindowSearchOptions {
  int max_iterations = 60;

  // Of the step left to go, in standard deviations.
  double precision = 0.02;

  // A gain of the cost below this share ends the search.
  double smallest_gain = 1e-10;

  // Of the first step, as a share of the squares: small where the search begins near its end.
  double first_damping = 1e-3;
};

struct WindowSearch {
  bool converged = false;
  std::string message;
  WindowPoint point;
  double cost = 0.0;    // at the point, without the barrier
  ReducedWindows near;  // where the last step was taken from
  int num_iterations = 0;
};

// The least weighed squares by Levenberg and Marquardt's steps, within the bounds of
// PhysicalBarrier.
WindowSearch SearchWindows(const WindowProblem& problem,
                           const std::vector<ChannelWeight>& weights,
                           const WindowPoint& start,
                           const WindowSearchOptions& options);

// The same over several choices of the windows, which share what they begin with. `parts`: the
// windows of each.
std::vector<WindowSearch> SearchParts(const WindowProblem& problem,
                                      const std::vector<ChannelWeight>& weights,
                                      const WindowPoint& start,
                                      const std::vector<std::vector<std::size_t>>& parts,
                                      const WindowSearchOptions& options);

}  // namespace fathom
