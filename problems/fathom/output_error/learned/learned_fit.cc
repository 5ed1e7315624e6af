// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/learned_fit.h"

#include "fathom/output_error/learned/learned_noise.h"
#include "fathom/output_error/learned/whitened_cost.h"
#include "fathom/output_error/search_within_bounds.h"

#include <limits>
#include <optional>
#include <utility>

#include <ceres/cost_function.h>
#include <ceres/problem.h>

namespace fathom {
namespace {

constexpr int kMostTurns = 3;
constexpr double kLeastGain = 0.1;  // of the log-likelihood, for another turn

WindowUnknowns UnknownsAt(const OutputErrorSummary& plain) {
  WindowUnknowns unknowns;
  unknowns.vehicle = BlockOf(plain.model);
  for (const auto& offset : plain.offsets) unknowns.offsets.push_back(offset.value);
  for (const InitialState& state : plain.initial_states) {
    unknowns.states.push_back({state.velocity, state.position});
  }
  return unknowns;
}

std::optional<std::vector<BinnedRun>> RunsAt(const WindowUnknowns& unknowns,
                                             std::span<const BinnedSegment> bins,
                                             const OffsetSharing& offsets) {
  std::vector<BinnedRun> runs;
  for (size_t s = 0; s < bins.size(); ++s) {
    const UncoupledModel<double> model =
        ModelOf(unknowns.vehicle.data(), unknowns.offsets[offsets.At(s)]);
    auto run = RunOverBins(model, StateOf(unknowns, s), bins[s]);
    if (!run) return std::nullopt;
    runs.push_back(*std::move(run));
  }
  return runs;
}

BoundedSolve SearchUnder(std::span<const Whitener> whiteners,
                         std::span<const BinnedSegment> bins,
                         const OutputErrorOptions& options,
                         WindowUnknowns* unknowns) {
  ceres::Problem problem;
  for (size_t s = 0; s < bins.size(); ++s) {
    problem.AddResidualBlock(MakeWhitenedCost(bins[s], whiteners[s]).release(),
                             nullptr,
                             unknowns->vehicle.data(),
                             &unknowns->offsets[options.offsets.At(s)],
                             unknowns->states[s].data());
  }
  BoundedSolveOptions solver;
  solver.max_iterations = options.max_iterations;
  solver.is_dense = bins.size() <= 8;
  return SolveWithBounds(
      solver, {kQuadraticDamping, kLinearDamping}, {}, unknowns->vehicle.data(), &problem);
}

}  // namespace

LearnedFit FitLearned(std::span<const BinnedSegment> bins,
                      const OutputErrorSummary& plain,
                      const OutputErrorOptions& options) {
  LearnedFit fit;
  fit.message = "The search under the learned noise does not converge.";
  WindowUnknowns unknowns = UnknownsAt(plain);
  auto runs = RunsAt(unknowns, bins, options.offsets);
  std::optional<NoiseModel> known;
  std::vector<Whitener> whiteners;
  double previous = -std::numeric_limits<double>::infinity();
  for (int turn = 0; runs && turn < kMostTurns; ++turn) {
    const NoiseFit learned = LearnNoise(bins, *runs, ModelOf(unknowns), options.offsets, known);
    if (!learned.IsUsable()) {
      fit.message = learned.message;
      return fit;
    }
    if (learned.log_likelihood < previous + kLeastGain) break;
    previous = learned.log_likelihood;
    known = fit.noise = learned.model;
    whiteners.clear();
    for (const BinnedSegment& part : bins) whiteners.emplace_back(fit.noise, part.samples);
    BoundedSolve solve = SearchUnder(whiteners, bins, options, &unknowns);
    if (!solve.converged) return fit;
    fit.held = std::move(solve.held);
    runs = RunsAt(unknowns, bins, options.offsets);
  }
  if (!runs) return fit;
  fit.converged = true;
  fit.message = "Converged.";
  fit.model = ModelOf(unknowns);
  fit.offsets = unknowns.offsets;
  for (size_t s = 0; s < bins.size(); ++s) fit.initial_states.push_back(StateOf(unknowns, s));
  fit.runs = *std::move(runs);
  for (size_t s = 0; s < bins.size(); ++s) {
    whiteners[s].Apply(fit.runs[s].columns, fit.runs[s].columns);
  }
  return fit;
}

}  // namespace fathom
