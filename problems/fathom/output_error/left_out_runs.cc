// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/left_out_runs.h"

#include "fathom/output_error/learned/binned_run.h"
#include "fathom/output_error/learned/binned_segment.h"
#include "fathom/output_error/learned/free_runs.h"
#include "fathom/signal/filters/wild_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fathom {
namespace {

constexpr std::size_t kFewestRuns = 2;
constexpr std::size_t kMostFolds = 4;

}  // namespace

std::optional<double> MoreMissedOfLeftOutRuns(std::span<const Segment> segments,
                                              const OutputErrorOptions& options,
                                              const OutputErrorSummary& plain,
                                              const WeighedFit& fit) {
  if (segments.size() < kFewestRuns) return std::nullopt;
  const double width = BinWidth(segments);
  const Refitted refitted =
      options.offsets.IsOneInAll() ? Refitted::kState : Refitted::kStateAndOffset;
  const std::size_t num_folds = std::min(kMostFolds, segments.size());
  const auto models = plain.ModelsIn(segments.size(), options.offsets);
  double missed_by_plain = 0.0, missed_by_learned = 0.0;  // sums of squares
  for (std::size_t fold = 0; fold < num_folds; ++fold) {
    std::vector<std::size_t> kept;
    std::vector<BinnedSegment> left_out;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      if (s % num_folds != fold) {
        kept.push_back(s);
        continue;
      }
      const auto residual =
          RunOverSamples(models[s], plain.initial_states[s], segments[s], options.output);
      if (residual.empty()) return std::nullopt;
      left_out.push_back(
          BinnedSegmentOf(segments[s], options.output, width, WildSamples(residual)));
    }
    const OutputErrorSummary by_plain = fit(kept, Weighting::kPlain);
    const OutputErrorSummary by_learned = fit(kept, Weighting::kLearned);
    if (!by_plain.converged || by_learned.weighting != Weighting::kLearned) return std::nullopt;
    const auto plain_runs =
        FreeRunsOf(std::vector(left_out.size(), by_plain.model), left_out, refitted);
    const auto learned_runs =
        FreeRunsOf(std::vector(left_out.size(), by_learned.model), left_out, refitted);
    if (!plain_runs || !learned_runs) return std::nullopt;
    missed_by_plain += plain_runs->sum_of_squares;
    missed_by_learned += learned_runs->sum_of_squares;
  }
  return std::sqrt(missed_by_learned / missed_by_plain) - 1.0;
}

}  // namespace fathom
