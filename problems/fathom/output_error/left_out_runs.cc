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

constexpr std::size_t kFewestRuns = 3;
constexpr std::size_t kMostFolds = 4;

}  // namespace

std::optional<double> MoreMissedOfLeftOutRuns(std::span<const Segment> segments,
                                              FittedOutput output,
                                              const OutputErrorSummary& plain,
                                              const WeighedFit& fit) {
  if (segments.size() < kFewestRuns) return std::nullopt;
  const double width = BinWidth(segments);
  const std::size_t num_folds = std::min(kMostFolds, segments.size());
  double missed_by_plain = 0.0, missed_by_learned = 0.0;  // sums of squares
  for (std::size_t fold = 0; fold < num_folds; ++fold) {
    std::vector<Segment> rest;
    std::vector<BinnedSegment> left_out;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      if (s % num_folds != fold) {
        rest.push_back(segments[s]);
        continue;
      }
      const auto residual =
          RunOverSamples(plain.model, plain.initial_states[s], segments[s], output);
      if (residual.empty()) return std::nullopt;
      left_out.push_back(BinnedSegmentOf(segments[s], output, width, WildSamples(residual)));
    }
    const OutputErrorSummary by_plain = fit(rest, Weighting::kPlain);
    const OutputErrorSummary by_learned = fit(rest, Weighting::kLearned);
    if (!by_plain.converged || by_learned.weighting != Weighting::kLearned) return std::nullopt;
    const auto plain_runs = FreeRunsOf(by_plain.model, left_out);
    const auto learned_runs = FreeRunsOf(by_learned.model, left_out);
    if (!plain_runs || !learned_runs) return std::nullopt;
    missed_by_plain += plain_runs->sum_of_squares;
    missed_by_learned += learned_runs->sum_of_squares;
  }
  return std::sqrt(missed_by_learned / missed_by_plain) - 1.0;
}

}  // namespace fathom
