// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/constrained_optimum.h"

#include "fathom/output_error/window_layout.h"

#include <memory>
#include <numeric>
#include <utility>

#include <ceres/cost_function.h>
#include <ceres/problem.h>

namespace fathom {
namespace {

std::unique_ptr<ceres::Problem> BuildProblem(std::vector<ShootingWindow> windows,
                                             double sigma,
                                             double huber_k,
                                             double continuity,
                                             WindowUnknowns* unknowns) {
  auto problem = std::make_unique<ceres::Problem>();
  const auto scratch = std::make_shared<SimulationScratch>();
  for (size_t w = 0; w < windows.size(); ++w) {
    windows[w].sigma = sigma;
    windows[w].huber_k = huber_k;
    std::vector<double*> blocks = {unknowns->vehicle.data(),
                                   &unknowns->offsets[windows[w].offset],
                                   unknowns->states[w].data()};
    if (Continues(windows, w)) {
      windows[w].continuity_sigma = continuity * sigma;
      blocks.push_back(unknowns->states[w + 1].data());
    }
    problem->AddResidualBlock(MakeWindowCost(windows[w], scratch).release(), nullptr, blocks);
  }
  return problem;
}

}  // namespace

InitialState StateOf(const WindowUnknowns& unknowns, std::size_t w) {
  return {unknowns.states[w][0], unknowns.states[w][1]};
}

UncoupledModel<double> ModelOf(const WindowUnknowns& unknowns) {
  const double sum = std::accumulate(unknowns.offsets.begin(), unknowns.offsets.end(), 0.0);
  return ModelOf(unknowns.vehicle.data(), sum / static_cast<double>(unknowns.offsets.size()));
}

UncoupledModel<double> ModelIn(const ShootingWindow& window, const WindowUnknowns& unknowns) {
  return ModelOf(unknowns.vehicle.data(), unknowns.offsets[window.offset]);
}

ConstrainedOptimum FindConstrainedOptimum(const std::vector<ShootingWindow>& windows,
                                          double sigma,
                                          double huber_k,
                                          const OutputErrorOptions& options,
                                          const WindowUnknowns& start) {
  WindowUnknowns unknowns = start;
  const auto problem = BuildProblem(windows, sigma, huber_k, options.continuity, &unknowns);
  BoundedSolveOptions solver;
  solver.max_iterations = options.max_iterations;
  // Every window has a handful of rows (docs/output_error.md (9)); with many windows the Jacobian
  // is sparse.
  solver.is_dense = unknowns.states.size() <= 8;
  BoundedSolve solve = SolveWithBounds(
      solver, {kQuadraticDamping, kLinearDamping}, {}, unknowns.vehicle.data(), problem.get());
  if (!solve.converged) {
    solve.message = "the search did not converge to a physical model.";
    unknowns = start;
  }
  return {std::move(solve), std::move(unknowns)};
}

}  // namespace fathom
