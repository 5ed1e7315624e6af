// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/learned_fit.h"

#include "fathom/output_error/caveats.h"
#include "fathom/output_error/constrained_optimum.h"
#include "fathom/output_error/learned/binned_run.h"
#include "fathom/output_error/learned/binned_segment.h"
#include "fathom/output_error/learned/learned_noise.h"
#include "fathom/output_error/learned/whitened_cost.h"
#include "fathom/signal/filters/wild_samples.h"

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ceres/cost_function.h>
#include <ceres/problem.h>

namespace fathom {
namespace {

constexpr int kMostTurns = 3;
constexpr double kLeastGain = 0.1;  // of the log-likelihood, for another turn

struct LearnedFit {
  bool converged = false;
  std::string message;                       // why not
  UncoupledModel<double> model;              // with the mean of the offsets
  std::vector<double> offsets;               // as in OutputErrorSummary
  std::vector<InitialState> initial_states;  // by segment
  std::vector<int> held;                     // dampings on their bound
  NoiseModel noise;                          // of the bins
  std::vector<BinnedRun> runs;               // by segment, there; whitened
};

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

// Noise and model in turns.
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

// What the plain fit misses over each segment. Empty if a segment cannot be simulated.
std::vector<std::vector<double>> ResidualsOf(const OutputErrorSummary& plain,
                                             std::span<const Segment> segments,
                                             const OutputErrorOptions& options) {
  const auto models = plain.ModelsIn(segments.size(), options.offsets);
  std::vector<std::vector<double>> residuals;
  for (size_t s = 0; s < segments.size(); ++s) {
    residuals.push_back(
        RunOverSamples(models[s], plain.initial_states[s], segments[s], options.output));
    if (residuals.back().empty()) return {};
  }
  return residuals;
}

// The samples averaged over bins, without those that are wild.
std::vector<BinnedSegment> BinsOf(std::span<const Segment> segments,
                                  FittedOutput output,
                                  std::span<const std::vector<bool>> is_wild,
                                  const UncoupledModel<double>& model) {
  const double width = BinWidth(segments);
  std::vector<BinnedSegment> bins;
  for (size_t s = 0; s < segments.size(); ++s) {
    bins.push_back(BinnedSegmentOf(segments[s], output, width, is_wild[s]));
  }
  SetDampingFactors(model, bins);
  return bins;
}

OutputErrorSummary SummaryOf(const LearnedFit& fit,
                             std::span<const Segment> segments,
                             const OutputErrorOptions& options,
                             const OutputErrorSummary& plain) {
  OutputErrorSummary summary;
  summary.converged = true;
  summary.weighting = Weighting::kLearned;
  summary.learned_noise = fit.noise;
  summary.initial_guess = plain.initial_guess;
  summary.initial_cost = plain.initial_cost;
  summary.num_iterations = plain.num_iterations;
  summary.model = fit.model;
  for (const int index : fit.held) summary.on_bound[index] = true;
  for (const double value : fit.offsets) summary.offsets.push_back({.value = value});
  summary.initial_states = fit.initial_states;
  std::vector<Samples> rows;
  summary.final_cost = 0.0;
  for (const BinnedRun& run : fit.runs) {
    rows.push_back({run.J(), run.residual().array()});
    summary.final_cost += 0.5 * run.residual().squaredNorm();
  }
  summary.Take(EvidenceOf(rows, options.offsets));
  DescribeEvidence(segments, options.output, &summary);
  return summary;
}

OutputErrorSummary Because(std::string reason, OutputErrorSummary summary) {
  summary.weighting_reason = std::move(reason);
  return summary;
}

}  // namespace

OutputErrorSummary FitUnderLearnedNoise(std::span<const Segment> segments,
                                        const OutputErrorOptions& options,
                                        OutputErrorSummary plain) {
  if (!plain.converged) return Because("The plain search did not converge.", std::move(plain));
  const auto residuals = ResidualsOf(plain, segments, options);
  if (residuals.empty()) return Because("A run over a whole segment diverges.", std::move(plain));
  std::vector<std::vector<bool>> is_wild;
  for (const auto& residual : residuals) is_wild.push_back(WildSamples(residual));
  const auto bins = BinsOf(segments, options.output, is_wild, plain.model);
  const LearnedFit fit = FitLearned(bins, plain, options);
  if (!fit.converged) {
    return Because("No noise can be learned: " + fit.message, std::move(plain));
  }
  return SummaryOf(fit, segments, options, plain);
}

}  // namespace fathom
