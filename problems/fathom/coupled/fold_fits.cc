// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/fold_fits.h"

#include "fathom/base/parallel_for.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/coupled/window_search.h"

#include <algorithm>
#include <cstddef>

namespace fathom {
namespace {

constexpr double kFoldPrecision = 0.15;  // in standard deviations
constexpr double kFoldDamping = 1e-6;

// Whether all folds take the channels that the noise of a fit is of.
bool HaveChannelsOf(const std::vector<Fold>& folds, const std::vector<ChannelNoise>& noise) {
  const auto are_those = [&](const std::vector<CoupledData>& logs) {
    return std::ranges::equal(noise, ChannelsOf(logs), {}, &ChannelNoise::channel);
  };
  return std::ranges::all_of(
      folds, [&](const Fold& fold) { return are_those(fold.train) && are_those(fold.unseen); });
}

// Each by itself.
std::vector<std::optional<CoupledModel>> FitOneByOne(const std::vector<Fold>& folds,
                                                     const MotionStructure& structure,
                                                     const CoupledSummary& fit,
                                                     const CoupledFitOptions& with) {
  CoupledFitOptions options = BegunAt(fit, with);
  options.learns_noise = false;
  std::vector<std::optional<CoupledModel>> models(folds.size());
  ParallelFor(static_cast<int>(folds.size()), [&](int f) {
    const auto at = static_cast<std::size_t>(f);
    CoupledSummary part = FitCoupled(folds[at].train, structure, options);
    if (part.converged) models[at] = std::move(part.model);
  });
  return models;
}

}  // namespace

std::vector<std::optional<CoupledModel>> FitFolds(const std::vector<Fold>& folds,
                                                  const MotionStructure& structure,
                                                  const CoupledSummary& fit,
                                                  const CoupledFitOptions& options) {
  if (!HaveChannelsOf(folds, fit.noise)) return FitOneByOne(folds, structure, fit, options);
  WindowProblem problem;
  problem.entries = structure.entries;
  problem.channels = ChannelsOf(folds.front().unseen);
  problem.free = FreeStartOf(folds.front().unseen, problem.channels);
  problem.body = options.body;
  problem.priors = fit.priors;
  // What is unseen in one fold or another is all there is.
  std::vector<std::vector<std::size_t>> parts(folds.size());
  for (std::size_t f = 0; f < folds.size(); ++f) {
    for (const CoupledWindow& window : CoupledWindowsOf(folds[f].unseen, options.window)) {
      for (std::size_t other = 0; other < folds.size(); ++other) {
        if (other != f) parts[other].push_back(problem.windows.size());
      }
      problem.windows.push_back(window);
    }
  }
  WindowPoint point;
  point.model = fit.model;
  point.model.dofs = structure.dofs;
  point.model.coriolis = structure.coriolis;
  const Vector6 least = Vector6::Constant(1e-9);
  point.model = MovedInside(point.model, structure.entries, options.body, least, least, least);
  for (const CoupledWindow& window : problem.windows) point.starts.push_back(window.start);
  std::vector<ChannelWeight> weights;
  for (const ChannelNoise& noise : fit.noise) weights.push_back({noise.whitener, options.huber_k});
  WindowSearchOptions with;
  with.max_iterations = options.max_iterations;
  with.precision = kFoldPrecision;
  with.first_damping = kFoldDamping;
  const std::vector<WindowSearch> searches = SearchParts(problem, weights, point, parts, with);
  std::vector<std::optional<CoupledModel>> models(folds.size());
  for (std::size_t f = 0; f < folds.size(); ++f) {
    if (searches[f].converged) models[f] = searches[f].point.model;
  }
  return models;
}

}  // namespace fathom
