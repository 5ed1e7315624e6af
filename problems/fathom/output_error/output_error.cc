// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/output_error.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/output_error/caveats.h"
#include "fathom/output_error/initial_guess.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <ceres/cost_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glog/logging.h>

namespace fathom {
namespace {

using State = std::array<double, 2>;  // velocity, position

// What the search moves. The inertia is carried as its logarithm.
struct Unknowns {
  std::array<double, kNumParameters> parameters = {};
  std::vector<State> states;  // one per window
};

const std::vector<double>& Measured(const Segment& segment, FittedOutput output) {
  return output == FittedOutput::kVelocity ? segment.velocity : segment.position;
}

// Cuts every segment into windows of about equal duration, at most options.shooting_window.
std::vector<ShootingWindow> LayOutWindows(std::span<const Segment> segments,
                                          const OutputErrorOptions& options) {
  std::vector<ShootingWindow> windows;
  for (const Segment& segment : segments) {
    const double duration = segment.time.back() - segment.time.front();
    const double num_windows = std::clamp(std::ceil(duration / options.shooting_window),
                                          1.0,
                                          static_cast<double>(segment.time.size()));
    size_t begin = 0;
    for (int k = 1; k <= num_windows; ++k) {
      const double t_end = segment.time.front() + duration * k / num_windows;
      size_t end = segment.time.size();
      if (k < num_windows) {
        end = std::lower_bound(segment.time.begin(), segment.time.end(), t_end) -
              segment.time.begin();
      }
      if (end <= begin) continue;  // a gap as long as a window
      windows.push_back(
          {.segment = &segment, .begin = begin, .end = end, .output = options.output});
      begin = end;
    }
  }
  return windows;
}

// True if the window after `index` continues the same segment.
bool Continues(const std::vector<ShootingWindow>& windows, size_t index) {
  return index + 1 < windows.size() && windows[index + 1].segment == windows[index].segment;
}

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

struct Constrained {
  bool converged = false;
  double initial_cost = 0.0;
  double cost = std::numeric_limits<double>::infinity();
  int num_iterations = 0;
  std::string message;
  std::vector<int> held_at_zero;
};

// The least cost with both dampings at least 0. Ceres' own bounds report convergence at a wrong
// point when one is active, so the active set is found here: the free optimum if it is feasible,
// otherwise the best feasible one of those with either or both dampings held at zero. (The
// constrained optimum is the free optimum of its own active set, so it is among them.)
Constrained SolveConstrained(const OutputErrorOptions& options,
                             ceres::Problem* problem,
                             Unknowns* unknowns) {
  const std::vector<std::vector<int>> active_sets = {
      {}, {kQuadraticDamping}, {kLinearDamping}, {kQuadraticDamping, kLinearDamping}};
  const Unknowns start = *unknowns;
  Unknowns best_unknowns = start;
  Constrained best;
  int num_iterations = 0;
  for (const auto& held_at_zero : active_sets) {
    *unknowns = start;
    for (const int index : held_at_zero) unknowns->parameters[index] = 0.0;
    const ceres::Solver::Summary summary = Solve(options, held_at_zero, unknowns, problem);
    num_iterations += static_cast<int>(summary.iterations.size());
    if (held_at_zero.empty()) best.initial_cost = summary.initial_cost;
    if (best.message.empty()) best.message = summary.message;
    if (summary.termination_type != ceres::CONVERGENCE) continue;
    const bool feasible = unknowns->parameters[kQuadraticDamping] >= 0.0 &&
                          unknowns->parameters[kLinearDamping] >= 0.0;
    if (!feasible || !PressesOnItsBounds(held_at_zero, unknowns, problem)) continue;
    if (summary.final_cost >= best.cost) continue;
    best.converged = true;
    best.cost = summary.final_cost;
    best.message = summary.message;
    best.held_at_zero = held_at_zero;
    best_unknowns = *unknowns;
    if (held_at_zero.empty()) break;
  }
  *unknowns = best_unknowns;
  if (!best.converged) best.message = "the search did not converge to a physical model.";
  best.num_iterations = num_iterations;
  return best;
}

// Robust standard deviation of the measurement about the present simulation: 1.4826 times the
// median absolute residual.
double ResidualSpread(const std::vector<ShootingWindow>& windows, const Unknowns& unknowns) {
  std::vector<double> sizes;
  for (size_t w = 0; w < windows.size(); ++w) {
    for (const double miss :
         WindowMisses(windows[w], unknowns.parameters.data(), unknowns.states[w].data())) {
      sizes.push_back(std::abs(miss));
    }
  }
  CHECK(!sizes.empty()) << "The search has converged, so its end can be simulated.";
  return 1.4826 * Median(std::move(sizes));
}

double RootMeanSquare(std::span<const Segment> segments, FittedOutput output) {
  double sum = 0.0, mean = 0.0, n = 0.0;
  for (const Segment& segment : segments) {
    for (const double y : Measured(segment, output)) {
      sum += y * y;
      mean += y;
      n += 1.0;
    }
  }
  mean /= n;
  return std::sqrt(std::max(0.0, sum / n - mean * mean));
}

void RequireUsable(std::span<const Segment> segments, const OutputErrorOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(
        fmt::format("The options of output error cannot be used: {}", fmt::join(problems, "; ")));
  }
  if (segments.empty()) throw InputError("Output error needs at least one segment of data.");
  size_t num_samples = 0;
  for (const Segment& segment : segments) num_samples += segment.time.size();
  const bool has_short = std::any_of(segments.begin(), segments.end(), [](const Segment& segment) {
    return segment.time.size() < 2;
  });
  const size_t num_unknowns = kNumParameters + segments.size() * StateSize(options.output);
  if (has_short || num_samples <= num_unknowns) {
    throw InputError(
        fmt::format("Output error has {} samples in {} segments, expected at least two in each and "
                    "more than its "
                    "{} unknowns.",
                    num_samples,
                    segments.size(),
                    num_unknowns));
  }
  for (const Segment& segment : segments) {
    if (Measured(segment, options.output).size() != segment.time.size()) {
      throw InputError("Output error was asked to fit the position, but the log has no poses.");
    }
  }
}

UncoupledModel<double> ModelOf(const Unknowns& unknowns) {
  return {std::exp(unknowns.parameters[kInertia]),
          unknowns.parameters[kQuadraticDamping],
          unknowns.parameters[kLinearDamping],
          unknowns.parameters[kBuoyancy]};
}

}  // namespace

OutputErrorSummary FitOutputError(std::span<const Segment> segments,
                                  const OutputErrorOptions& options) {
  RequireUsable(segments, options);
  OutputErrorSummary summary;
  InitialGuess guess;
  if (options.initial_guess) {
    guess = {*options.initial_guess, "given"};
  } else {
    guess = ChooseInitialGuess(segments);
  }
  summary.initial_guess = guess.family;

  const std::vector<ShootingWindow> windows = LayOutWindows(segments, options);
  Unknowns unknowns;
  unknowns.parameters = {std::log(guess.model.inertia),
                         guess.model.quadratic_damping,
                         guess.model.linear_damping,
                         guess.model.buoyancy};
  for (const ShootingWindow& window : windows) {
    const Segment& segment = *window.segment;
    unknowns.states.push_back({segment.velocity[window.begin],
                               segment.position.empty() ? 0.0 : segment.position[window.begin]});
  }

  // Plain least squares first; then, with the noise level known, with the robust loss. Wild samples
  // spoil the first estimate of that level, so it is repeated until it settles.
  const double spread = std::max(RootMeanSquare(segments, options.output), 1e-12);
  const double kNever = std::numeric_limits<double>::infinity();
  double sigma = 0.1 * spread;
  auto problem = BuildProblem(windows, sigma, kNever, options.continuity, &unknowns);
  Constrained solution = SolveConstrained(options, problem.get(), &unknowns);
  summary.initial_cost = solution.initial_cost;
  summary.num_iterations = solution.num_iterations;
  constexpr int kMostRepetitions = 4;
  for (int i = 0; i < kMostRepetitions && solution.converged && options.huber_k < kNever; ++i) {
    const double previous_sigma = sigma;
    sigma = std::max(ResidualSpread(windows, unknowns), 1e-9 * spread);
    problem = BuildProblem(windows, sigma, options.huber_k, options.continuity, &unknowns);
    solution = SolveConstrained(options, problem.get(), &unknowns);
    summary.num_iterations += solution.num_iterations;
    if (std::abs(sigma - previous_sigma) < 0.1 * previous_sigma) break;
  }
  summary.message = solution.message;
  summary.converged = solution.converged;
  if (!solution.converged) return summary;

  problem.reset();  // its buffers are as large as what the evidence needs next
  summary.final_cost = solution.cost;
  summary.model = ModelOf(unknowns);
  for (const int index : solution.held_at_zero) summary.on_bound[index] = true;
  for (size_t w = 0; w < windows.size(); ++w) {
    if (w > 0 && Continues(windows, w - 1)) continue;
    summary.initial_states.push_back({unknowns.states[w][0], unknowns.states[w][1]});
  }
  summary.evidence = EvidenceAt(
      summary.model, segments, summary.initial_states, options.output, sigma, options.huber_k);
  summary.covariance = summary.evidence.covariance;
  DescribeEvidence(segments, &summary);
  return summary;
}

}  // namespace fathom
