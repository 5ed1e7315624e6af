// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/choose_weighting.h"

#include "fathom/output_error/caveats.h"
#include "fathom/output_error/learned/binned_segment.h"
#include "fathom/output_error/learned/free_runs.h"
#include "fathom/output_error/learned/learned_fit.h"
#include "fathom/output_error/learned/learned_noise.h"
#include "fathom/output_error/learned/whiteness.h"
#include "fathom/signal/filters/wild_samples.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

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
                             const OffsetSharing& offsets,
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
  summary.Take(EvidenceOf(rows, offsets));
  DescribeEvidence(segments, &summary);
  return summary;
}

OutputErrorSummary Because(std::string reason, OutputErrorSummary summary) {
  summary.weighting_reason = std::move(reason);
  return summary;
}

// The learned answer, unless its free runs miss more than those of the plain one are expected to
// miss of data that it was not fitted to; docs/output_error.md (14).
OutputErrorSummary Judged(std::span<const BinnedSegment> bins,
                          const OffsetSharing& offsets,
                          OutputErrorSummary plain,
                          OutputErrorSummary learned) {
  if (!learned.IsUsable()) {
    return Because("Under the learned noise the data do not determine the model.",
                   std::move(plain));
  }
  const auto by_plain = FreeRunsOf(plain.ModelsIn(bins.size(), offsets), bins);
  const auto by_learned = FreeRunsOf(learned.ModelsIn(bins.size(), offsets), bins);
  if (!by_plain || !by_learned) {
    return Because("A free run diverges from a state within the log.", std::move(plain));
  }
  const auto more_by = [&](double sum_of_squares) {
    return 100.0 * (std::sqrt(sum_of_squares / by_plain->sum_of_squares) - 1.0);
  };
  const double change = more_by(by_learned->sum_of_squares);
  const double limit = more_by(by_plain->ExpectedOfLeftOutData(plain.covariance));
  const bool is_as_good = change <= limit;
  const std::string figures = fmt::format(
      "simulated from the command alone they miss {:+.1f} % compared with plain ones, {} the "
      "{:.1f} "
      "% that chance allows",
      change,
      is_as_good ? "within" : "above",
      limit);
  if (is_as_good) {
    return Because("Learned weights predict as well: " + figures + ".", std::move(learned));
  }
  return Because("Learned weights predict worse: " + figures +
                     ". What they take for a disturbance is structure that the model lacks.",
                 std::move(plain));
}

}  // namespace

OutputErrorSummary ChooseWeighting(std::span<const Segment> segments,
                                   const OutputErrorOptions& options,
                                   OutputErrorSummary plain) {
  if (options.weighting == Weighting::kPlain) return Because("It was asked for.", std::move(plain));
  if (!plain.converged) return Because("The plain search did not converge.", std::move(plain));
  const bool is_auto = options.weighting == Weighting::kAuto;
  if (is_auto && !plain.IsUsable()) {
    return Because("The data do not determine the model by plain squares.", std::move(plain));
  }
  const auto residuals = ResidualsOf(plain, segments, options);
  if (residuals.empty()) return Because("A run over a whole segment diverges.", std::move(plain));
  if (is_auto && IsWhite(residuals)) {
    return Because("The residual is white noise: no other weights are better.", std::move(plain));
  }
  std::vector<std::vector<bool>> is_wild;
  for (const auto& residual : residuals) is_wild.push_back(WildSamples(residual));
  const auto bins = BinsOf(segments, options.output, is_wild, plain.model);
  const LearnedFit fit = FitLearned(bins, plain, options);
  if (!fit.converged) {
    return Because("No noise can be learned: " + fit.message, std::move(plain));
  }
  OutputErrorSummary learned = SummaryOf(fit, segments, options.offsets, plain);
  if (!is_auto) return Because("It was asked for.", std::move(learned));
  return Judged(bins, options.offsets, std::move(plain), std::move(learned));
}

}  // namespace fathom
