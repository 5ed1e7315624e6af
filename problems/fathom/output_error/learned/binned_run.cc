// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/binned_run.h"

#include "fathom/output_error/signatures.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace fathom {
namespace {

// Simulates a segment a stretch at a time, so that memory does not grow with the log, and calls
// visit(begin, samples) for each. False if the simulation diverges.
template <typename Visit>
bool VisitStretches(const UncoupledModel<double>& model,
                    const InitialState& initial,
                    const Segment& segment,
                    FittedOutput output,
                    Visit visit) {
  constexpr std::size_t kStretch = 4096;  // samples: they fit into the cache
  const std::size_t n = segment.time.size();
  StretchStart start = SegmentStart(initial);
  Stretch stretch;
  Samples samples;
  for (std::size_t begin = 0; begin < n; begin += kStretch) {
    // The next stretch's first sample is simulated as well: that is where it starts.
    const std::size_t end = std::min(begin + kStretch, n);
    const auto time = std::span(segment.time).subspan(begin, std::min(end + 1, n) - begin);
    if (!SimulateStretch(model, segment.command, time, output, &start, &stretch)) return false;
    FillSamples(model, segment, begin, end, output, 1.0, stretch, &samples);
    visit(begin, samples);
  }
  return true;
}

}  // namespace

std::optional<BinnedRun> RunOverBins(const UncoupledModel<double>& model,
                                     const InitialState& initial,
                                     const BinnedSegment& bins) {
  BinnedRun run;
  run.output = bins.output;
  run.columns.setZero(bins.size(), BinnedRun::kNumColumns);
  const auto add = [&](std::size_t begin, const Samples& samples) {
    for (Eigen::Index row = 0; row < samples.residual.size(); ++row) {
      const int bin = bins.bin_of[begin + row];
      if (bin < 0) continue;
      const double share = 1.0 / bins.count[bin];
      auto to = run.columns.row(bin);
      to.head(samples.J.cols()) += share * samples.J.row(row);
      to[BinnedRun::kNumColumns - 1] += share * samples.residual[row];
    }
  };
  if (!VisitStretches(model, initial, *bins.segment, bins.output, add)) return std::nullopt;
  return run;
}

std::vector<double> RunOverSamples(const UncoupledModel<double>& model,
                                   const InitialState& initial,
                                   const Segment& segment,
                                   FittedOutput output) {
  std::vector<double> residual;
  residual.reserve(segment.time.size());
  const auto append = [&](std::size_t /*begin*/, const Samples& samples) {
    residual.insert(residual.end(), samples.residual.begin(), samples.residual.end());
  };
  if (!VisitStretches(model, initial, segment, output, append)) return {};
  return residual;
}

}  // namespace fathom
