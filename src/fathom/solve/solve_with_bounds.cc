// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/solve_with_bounds.h"

#include "fathom/solve/active_set.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

namespace fathom {
namespace {

ceres::Solver::Options SolverOptions(const BoundedSolveOptions& options) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = options.is_dense ? ceres::DENSE_QR : ceres::SPARSE_NORMAL_CHOLESKY;
  solver.max_num_iterations = options.max_iterations;
  solver.num_threads = 1;
  solver.initial_trust_region_radius = options.initial_trust_region_radius;
  solver.function_tolerance = options.function_tolerance;
  solver.parameter_tolerance = 1e-9;
  solver.gradient_tolerance = 1e-12;
  solver.logging_type = ceres::SILENT;
  return solver;
}

double SecondsPerIteration(const ceres::Solver::Summary& summary) {
  double seconds = 0.0;
  for (size_t i = 1; i < summary.iterations.size(); ++i) {
    seconds += summary.iterations[i].iteration_time_in_seconds;
  }
  return seconds / static_cast<double>(summary.iterations.size() - 1);
}

// Ceres' search with entries of `block` held or free.
class BlockSearch final : public BoundedSearch {
 public:
  // Counts and times go to `counts`.
  BlockSearch(const BoundedSolveOptions& options,
              std::vector<int> constant,
              double* block,
              ceres::Problem* problem,
              BoundedSolve* counts)
      : options_(SolverOptions(options)),
        constant_(std::move(constant)),
        block_(block),
        problem_(problem),
        counts_(counts) {
    problem->GetParameterBlocks(&all_blocks_);
  }

  Optimum Solve(const std::vector<int>& held) override {
    std::vector<int> entries = constant_;
    entries.insert(entries.end(), held.begin(), held.end());
    HoldEntries(block_, std::move(entries), problem_);
    ceres::Solver::Summary summary;
    ceres::Solve(options_, problem_, &summary);
    if (counts_->num_iterations == 0) counts_->initial_cost = summary.initial_cost;
    counts_->num_iterations += static_cast<int>(summary.iterations.size());
    if (summary.iterations.size() > 1) {
      counts_->seconds_per_iteration = SecondsPerIteration(summary);
    }
    return {summary.termination_type == ceres::CONVERGENCE, summary.final_cost, summary.message};
  }

  double Value(int entry) const override { return block_[entry]; }
  void SetToZero(int entry) override { block_[entry] = 0.0; }

  std::vector<double> Point() const override {
    std::vector<double> point;
    for (const double* const block : all_blocks_) {
      point.insert(point.end(), block, block + problem_->ParameterBlockSize(block));
    }
    return point;
  }

  void GoTo(const std::vector<double>& point) override {
    const double* from = point.data();
    for (double* const block : all_blocks_) {
      const int size = problem_->ParameterBlockSize(block);
      std::copy_n(from, size, block);
      from += size;
    }
  }

 private:
  const ceres::Solver::Options options_;
  const std::vector<int> constant_;
  double* const block_;
  ceres::Problem* const problem_;
  BoundedSolve* const counts_;
  std::vector<double*> all_blocks_;
};

}  // namespace

void HoldEntries(double* block, std::vector<int> entries, ceres::Problem* problem) {
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  const int size = problem->ParameterBlockSize(block);
  if (static_cast<int>(entries.size()) == size) {
    problem->SetParameterBlockConstant(block);
    return;
  }
  problem->SetParameterBlockVariable(block);
  problem->SetManifold(block, entries.empty() ? nullptr : new ceres::SubsetManifold(size, entries));
}

BoundedSolve SolveWithBounds(const BoundedSolveOptions& options,
                             const std::vector<int>& bounded,
                             const std::vector<int>& constant,
                             double* block,
                             ceres::Problem* problem) {
  BoundedSolve result;
  BlockSearch search(options, constant, block, problem, &result);
  BoundedOptimum optimum = SearchActiveSet(bounded, options.function_tolerance, &search);
  result.converged = optimum.converged;
  result.message = std::move(optimum.message);
  result.cost = optimum.cost;
  result.held = std::move(optimum.held);
  return result;
}

}  // namespace fathom
