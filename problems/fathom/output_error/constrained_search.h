// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/options.h"
#include "fathom/output_error/shooting_window.h"
#include "fathom/vehicle/parameters.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace fathom {

// What the search moves. The inertia is carried as its logarithm.
struct Unknowns {
  std::array<double, kNumParameters> parameters = {};
  std::vector<std::array<double, 2>> states;  // of each window: velocity, position
};

// Where a search ended.
struct ConstrainedOptimum {
  bool converged = false;
  double initial_cost = 0.0;
  double cost = std::numeric_limits<double>::infinity();
  int num_iterations = 0;
  std::string message;
  std::vector<int> held_at_zero;  // dampings
  Unknowns unknowns;              // where it began, if it did not converge
};

// The least cost with both dampings at least 0, from `start`; `sigma` and `huber_k` as in
// ShootingWindow. Ceres' own bounds report convergence at a wrong point when one is active, so the
// active set is found here: the free optimum if it is feasible, otherwise the best feasible one of
// those with either or both dampings held at zero. (The constrained optimum is the free optimum of
// its own active set, so it is among them.)
ConstrainedOptimum SearchWithinBounds(const std::vector<ShootingWindow>& windows,
                                      double sigma,
                                      double huber_k,
                                      const OutputErrorOptions& options,
                                      const Unknowns& start);

}  // namespace fathom
