// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/constrained_search.h"

#include "fathom/output_error/window_layout.h"

#include <algorithm>
#include <memory>

#include <ceres/cost_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

namespace fathom {
namespace {

std::unique_ptr<ceres::Problem> BuildProblem(std::vector<ShootingWindow> windows,
                                             double sigma,
                                             double huber_k,
                                             double continuity,
                                             Unknowns* unknowns) {
  auto problem = std::make_unique<ceres::Problem>();
  const auto scratch = std::make_shared<SimulationScratch>();
  for (size_t w = 0; w < windows.size(); ++w) {
    windows[w].sigma = sigma;
    windows[w].huber_k = huber_k;
    std::vector<double*> blocks = {unknowns->parameters.data(), unknowns->states[w].data()};
    if (Continues(windows, w)) {
      windows[w].continuity_sigma = continuity * sigma;
      blocks.push_back(unknowns->states[w + 1].data());
    }
    problem->AddResidualBlock(MakeWindowCost(windows[w], scratch).release(), nullptr, blocks);
  }
  return problem;
}

ceres::Solver::Summary Solve(const OutputErrorOptions& options,
                             const std::vector<int>& held_at_zero,
                             Unknowns* unknowns,
                             ceres::Problem* problem) {
  problem->SetManifold(
      unknowns->parameters.data(),
      held_at_zero.empty() ? nullptr : new ceres::SubsetManifold(kNumParameters, held_at_zero));
  ceres::Solver::Options solver;
  solver.max_num_iterations = options.max_iterations;
  // Every window has a handful of rows (docs/output_error.md (9)); with many windows the Jacobian
  // is sparse.
  solver.linear_solver_type =
      unknowns->states.size() <= 8 ? ceres::DENSE_QR : ceres::SPARSE_NORMAL_CHOLESKY;
  solver.function_tolerance = 1e-9;
  solver.parameter_tolerance = 1e-9;
  solver.gradient_tolerance = 1e-12;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, problem, &summary);
  return summary;
}

// True if letting go of any damping that is held at zero would raise the cost on the feasible side:
// the condition of Karush, Kuhn and Tucker.
bool PressesOnItsBounds(const std::vector<int>& held_at_zero,
                        Unknowns* unknowns,
                        ceres::Problem* problem) {
  if (held_at_zero.empty()) return true;
  problem->SetManifold(unknowns->parameters.data(), nullptr);
  ceres::Problem::EvaluateOptions options;
  options.parameter_blocks = {unknowns->parameters.data()};
  std::vector<double> gradient;
  if (!problem->Evaluate(options, nullptr, nullptr, &gradient, nullptr)) return false;
  return std::all_of(
      held_at_zero.begin(), held_at_zero.end(), [&](int index) { return gradient[index] >= 0.0; });
}

}  // namespace

ConstrainedOptimum SearchWithinBounds(const std::vector<ShootingWindow>& windows,
                                      double sigma,
                                      double huber_k,
                                      const OutputErrorOptions& options,
                                      const Unknowns& start) {
  const std::vector<std::vector<int>> active_sets = {
      {}, {kQuadraticDamping}, {kLinearDamping}, {kQuadraticDamping, kLinearDamping}};
  Unknowns unknowns = start;
  const auto problem = BuildProblem(windows, sigma, huber_k, options.continuity, &unknowns);
  ConstrainedOptimum best;
  best.unknowns = start;
  int num_iterations = 0;
  for (const auto& held_at_zero : active_sets) {
    unknowns = start;
    for (const int index : held_at_zero) unknowns.parameters[index] = 0.0;
    const ceres::Solver::Summary summary = Solve(options, held_at_zero, &unknowns, problem.get());
    num_iterations += static_cast<int>(summary.iterations.size());
    if (held_at_zero.empty()) best.initial_cost = summary.initial_cost;
    if (best.message.empty()) best.message = summary.message;
    if (summary.termination_type != ceres::CONVERGENCE) continue;
    const bool feasible =
        unknowns.parameters[kQuadraticDamping] >= 0.0 && unknowns.parameters[kLinearDamping] >= 0.0;
    if (!feasible || !PressesOnItsBounds(held_at_zero, &unknowns, problem.get())) continue;
    if (summary.final_cost >= best.cost) continue;
    best.converged = true;
    best.cost = summary.final_cost;
    best.message = summary.message;
    best.held_at_zero = held_at_zero;
    best.unknowns = unknowns;
    if (held_at_zero.empty()) break;
  }
  if (!best.converged) best.message = "the search did not converge to a physical model.";
  best.num_iterations = num_iterations;
  return best;
}

}  // namespace fathom
