// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/damping_search.h"

#include <algorithm>

#include <ceres/manifold.h>

namespace fathom {

void Hold(double* block,
          const std::vector<double>& std,
          std::vector<int> also,
          ceres::Problem* problem) {
  for (size_t i = 0; i < std.size(); ++i) {
    if (std[i] == 0.0) also.push_back(static_cast<int>(i));
  }
  std::sort(also.begin(), also.end());
  also.erase(std::unique(also.begin(), also.end()), also.end());
  if (also.size() == std.size()) {
    problem->SetParameterBlockConstant(block);
    return;
  }
  problem->SetParameterBlockVariable(block);
  problem->SetManifold(
      block,
      also.empty() ? nullptr : new ceres::SubsetManifold(static_cast<int>(std.size()), also));
}

BoundedSearch::Optimum DampingSearch::Solve(const std::vector<int>& held) {
  Hold(model_, model_std_, held, problem_);
  ceres::Solver::Summary summary;
  ceres::Solve(options_, problem_, &summary);
  if (counts_->num_iterations == 0) counts_->initial_cost = summary.initial_cost;
  counts_->num_iterations += static_cast<int>(summary.iterations.size());
  if (summary.iterations.size() > 1) {
    double seconds = 0.0;
    for (size_t i = 1; i < summary.iterations.size(); ++i) {
      seconds += summary.iterations[i].iteration_time_in_seconds;
    }
    counts_->seconds_per_iteration = seconds / static_cast<double>(summary.iterations.size() - 1);
  }
  return {summary.termination_type == ceres::CONVERGENCE, summary.final_cost, summary.message};
}

std::vector<double> DampingSearch::Point() const {
  std::vector<double> point;
  for (const double* const block : blocks_) {
    point.insert(point.end(), block, block + problem_->ParameterBlockSize(block));
  }
  return point;
}

void DampingSearch::GoTo(const std::vector<double>& point) {
  const double* from = point.data();
  for (double* const block : blocks_) {
    const int size = problem_->ParameterBlockSize(block);
    std::copy_n(from, size, block);
    from += size;
  }
}

}  // namespace fathom
