// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_fit.h"

#include "fathom/base/input_error.h"
#include "fathom/coupled/channel_noise.h"
#include "fathom/coupled/fit_passes.h"
#include "fathom/coupled/judged_fit.h"
#include "fathom/coupled/momentum_start.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/coupled/window_search.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kShortRun = 0.25;       // of the window's length
constexpr double kLeastDiagonal = 1e-9;  // [unit of the entry] of a start that is given

// A model, and the starts that were measured.
WindowPoint StartOf(const WindowProblem& problem, const CoupledModel& model) {
  WindowPoint point = {model, {}};
  for (const CoupledWindow& window : problem.windows) point.starts.push_back(window.start);
  return point;
}

// The guess brought nearer by runs of a quarter of the window's length, under white noise: long
// runs of a poor guess have many valleys. As it was where that leads nowhere.
CoupledModel BroughtNearer(const CoupledModel& guess,
                           std::span<const CoupledData> logs,
                           const CoupledFitOptions& options,
                           WindowProblem problem) {
  problem.windows = CoupledWindowsOf(logs, kShortRun * options.window);
  const WindowPoint point = StartOf(problem, guess);
  std::vector<WindowResiduals> residuals;
  if (!AllResiduals(problem, point, &residuals)) return guess;
  const auto noise = WhiteNoiseOf(residuals, problem.channels, QuietestSensors(problem));
  const auto weights = WeightsOf(noise, options.huber_k);
  return SearchWindows(problem, weights, point, RoughSearch(options)).point.model;
}

void CheckOptions(const CoupledFitOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError("CoupledFitOptions: " + problems.front() + ".");
  }
}

// Those of the entries that are free.
std::vector<EntryPrior> PriorsOf(const std::vector<FreeEntry>& entries,
                                 const std::vector<EntryPrior>& all) {
  std::vector<EntryPrior> priors;
  std::ranges::copy_if(all, std::back_inserter(priors), [&](const EntryPrior& prior) {
    return std::ranges::count(entries, prior.entry) > 0;
  });
  return priors;
}

WindowProblem ProblemOf(std::span<const CoupledData> logs,
                        const MotionStructure& structure,
                        const CoupledFitOptions& options) {
  WindowProblem problem;
  problem.windows = CoupledWindowsOf(logs, options.window);
  problem.entries = structure.entries;
  problem.channels = ChannelsOf(logs);
  problem.free = FreeStartOf(logs, problem.channels);
  problem.body = options.body;
  problem.priors = PriorsOf(structure.entries, options.priors);
  return problem;
}

// Of a fit that has not begun.
CoupledSummary SummaryOf(const WindowProblem& problem) {
  CoupledSummary summary;
  summary.entries = problem.entries;
  summary.priors = problem.priors;
  const auto size = static_cast<Eigen::Index>(problem.entries.size());
  summary.covariance =
      Eigen::MatrixXd::Constant(size, size, std::numeric_limits<double>::quiet_NaN());
  return summary;
}

CoupledSummary WithMessage(CoupledSummary summary, std::string message) {
  summary.message = std::move(message);
  return summary;
}

// A start that is given, as a model of this structure, within what a body can be.
CoupledModel GivenGuess(CoupledModel start,
                        const MotionStructure& structure,
                        const RigidBody& body) {
  start.dofs = structure.dofs;
  start.coriolis = structure.coriolis;
  const Vector6 least = Vector6::Constant(kLeastDiagonal);
  return MovedInside(start, structure.entries, body, least, least, least);
}

CoupledModel FirstGuess(std::span<const CoupledData> logs,
                        const MotionStructure& structure,
                        const CoupledFitOptions& options,
                        const WindowProblem& problem) {
  if (options.start) return GivenGuess(*options.start, structure, options.body);
  const CoupledModel guess = MomentumStart(logs, structure, options.held, options.body);
  return BroughtNearer(guess, logs, options, problem);
}

// A guess, and the starts that another fit found, or that were measured.
WindowPoint FirstPoint(const WindowProblem& problem,
                       const CoupledModel& guess,
                       const std::vector<CoupledState>& given_starts) {
  WindowPoint point = StartOf(problem, guess);
  if (given_starts.size() == problem.windows.size()) point.starts = given_starts;
  return point;
}

// What the passes found, not judged yet.
CoupledSummary WithPasses(CoupledSummary summary, const FitPasses& passes) {
  const WindowSearch& best = passes.best;
  summary.num_iterations = passes.num_iterations;
  summary.noise = passes.noise;
  summary.model = best.point.model;
  summary.message = best.message;
  summary.converged = best.converged;
  if (!best.converged) {
    std::ranges::copy_if(summary.entries, std::back_inserter(summary.open_inertias), IsOwnInertia);
    return summary;
  }
  summary.starts = best.point.starts;
  summary.cost = best.cost;
  summary.num_rows = best.near.num_rows;
  return summary;
}

CoupledSummary FitWithPriors(std::span<const CoupledData> logs,
                             const MotionStructure& structure,
                             const CoupledFitOptions& options) {
  CheckOptions(options);
  const WindowProblem problem = ProblemOf(logs, structure, options);
  CoupledSummary summary = SummaryOf(problem);
  if (problem.windows.empty()) {
    return WithMessage(std::move(summary),
                       "nothing is left to train on: the held-out intervals take all of the data");
  }
  const CoupledModel guess = FirstGuess(logs, structure, options, problem);
  const WindowPoint start = FirstPoint(problem, guess, options.window_starts);
  std::vector<WindowResiduals> residuals;
  if (!AllResiduals(problem, start, &residuals)) {
    summary.model = guess;
    return WithMessage(std::move(summary), "the first guess diverges");
  }
  summary = WithPasses(std::move(summary), FitInPasses(problem, start, residuals, options));
  if (!summary.converged) return summary;
  if (!options.learns_noise) {
    summary.determined = true;
    return WithMessage(std::move(summary), "converged");
  }
  return Judged(std::move(summary), problem, options.huber_k);
}

}  // namespace

CoupledSummary FitCoupled(std::span<const CoupledData> logs,
                          const MotionStructure& structure,
                          const CoupledFitOptions& options) {
  CoupledSummary fit = FitWithPriors(logs, structure, options);
  const auto priors = InertiasAlike(fit.model, fit.open_inertias, structure.entries);
  if (priors.empty()) return fit;
  CoupledFitOptions again = options;
  again.start = fit.model;
  again.priors.insert(again.priors.end(), priors.begin(), priors.end());
  CoupledSummary held = FitWithPriors(logs, structure, again);
  return held.IsUsable() || !fit.IsUsable() ? held : fit;
}

}  // namespace fathom
