// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/free_runs.h"

#include "fathom/output_error/learned/binned_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr double kLongestRun = 60.0;  // [s]

// Samples `begin` to `end` - 1 as a segment of their own.
Segment PartOf(const Segment& whole, std::size_t begin, std::size_t end) {
  const auto cut = [&](const std::vector<double>& values) {
    const auto part = std::span(values).subspan(begin, end - begin);
    return std::vector<double>(part.begin(), part.end());
  };
  Segment part;
  part.time = cut(whole.time);
  part.velocity = cut(whole.velocity);
  if (!whole.position.empty()) part.position = cut(whole.position);
  part.command = whole.command.Between(part.time.front(), part.time.back());
  return part;
}

// Adds the run over samples `begin` to `end` - 1. False if it diverges.
bool AddRun(const UncoupledModel<double>& model,
            const BinnedSegment& whole,
            std::size_t begin,
            std::size_t end,
            Refitted refitted,
            FreeRuns* runs) {
  const Segment segment = PartOf(*whole.segment, begin, end);
  std::vector<bool> is_wild;
  for (std::size_t i = begin; i < end; ++i) is_wild.push_back(whole.bin_of[i] < 0);
  const auto first = std::find(is_wild.begin(), is_wild.end(), false) - is_wild.begin();
  if (first == std::ssize(is_wild)) return true;
  const InitialState near = {segment.velocity[first],
                             segment.position.empty() ? 0.0 : segment.position[first]};
  const auto run =
      RunOverBins(model, near, BinnedSegmentOf(segment, whole.output, whole.width, is_wild));
  if (!run) return false;
  Eigen::MatrixXd rows(run->columns.rows(), kNumParameters + 1);
  rows << run->parameters(), run->residual();
  Eigen::MatrixXd own = run->state();
  if (refitted == Refitted::kStateAndOffset) {
    own.conservativeResize(Eigen::NoChange, own.cols() + 1);
    own.rightCols(1) = run->parameters().col(kBuoyancy);
  }
  rows -= own * own.colPivHouseholderQr().solve(rows);
  runs->gram += rows.leftCols(kNumParameters).transpose() * rows.leftCols(kNumParameters);
  runs->sum_of_squares += rows.col(kNumParameters).squaredNorm();
  return true;
}

}  // namespace

std::optional<FreeRuns> FreeRunsOf(std::span<const UncoupledModel<double>> models,
                                   std::span<const BinnedSegment> bins,
                                   Refitted refitted) {
  FreeRuns runs;
  for (std::size_t s = 0; s < bins.size(); ++s) {
    const BinnedSegment& whole = bins[s];
    const std::vector<double>& time = whole.segment->time;
    const double duration = time.back() - time.front();
    const double num_runs = std::max(1.0, std::ceil(duration / kLongestRun));
    std::size_t begin = 0;
    for (int k = 1; k <= num_runs; ++k) {
      const auto past =
          std::lower_bound(time.begin(), time.end(), time.front() + duration * k / num_runs);
      const auto end = k < num_runs ? static_cast<std::size_t>(past - time.begin()) : time.size();
      if (end > begin && !AddRun(models[s], whole, begin, end, refitted, &runs)) {
        return std::nullopt;
      }
      begin = end;
    }
  }
  return runs;
}

}  // namespace fathom
