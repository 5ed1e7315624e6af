// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace ceres {
class Problem;
}

namespace fathom {

struct BoundedSolveOptions {
  int max_iterations = 100;
  double function_tolerance = 1e-9;  // a share of the cost
  double initial_trust_region_radius = 1e4;
  bool is_dense = false;  // for problems of a few dozen rows
};

// Where a search ended.
struct BoundedSolve {
  bool converged = false;
  std::string message;
  double initial_cost = 0.0;
  double cost = 0.0;
  int num_iterations = 0;
  double seconds_per_iteration = 0.0;  // of the last of Ceres' searches
  std::vector<int> held;               // entries on their bound, rising
};

// Holds these entries of a block, and lets go of its others.
void HoldEntries(double* block, std::vector<int> entries, ceres::Problem* problem);

// The least cost with the entries `bounded` of `block` at least 0, and its entries `constant` where
// they are. Ceres' own bounds report convergence at a wrong point when one is active, so the active
// set is found outside, by SearchActiveSet(). All blocks move to where the search ends. One thread:
// with more the cost is summed in another order, which changes the last bits.
BoundedSolve SolveWithBounds(const BoundedSolveOptions& options,
                             const std::vector<int>& bounded,
                             const std::vector<int>& constant,
                             double* block,
                             ceres::Problem* problem);

}  // namespace fathom
