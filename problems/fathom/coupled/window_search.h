// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/fitted_channel.h"
#include "fathom/coupled/window_residuals.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What a search over windows needs to know, and does not change.
struct WindowProblem {
  std::vector<CoupledWindow> windows;
  std::vector<FreeEntry> entries;
  std::vector<FittedChannel> channels;
  FreeStart free;
  RigidBody body;
};

// A point of the search.
struct WindowPoint {
  CoupledModel model;
  std::vector<CoupledState> starts;  // of each window
};

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

// The residuals of all windows, nothing where a run diverges.
bool AllResiduals(const WindowProblem& problem,
                  const WindowPoint& point,
                  std::vector<WindowResiduals>* residuals);

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
