// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/held_samples.h"

#include "fathom/base/median.h"
#include "fathom/base/quantile.h"
#include "fathom/findings/values/equal_runs.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace fathom {
namespace {

constexpr std::size_t kFewestRuns = 20;
constexpr double kSmallestChange = 0.01;  // a quantile
constexpr double kSeveral = 4.0;
constexpr double kMostAlone = 0.2;  // of the values, in one row only
constexpr double kLongRun = 1.5;    // usual lengths
constexpr double kMostLong = 0.2;   // of the values, for longer than that

}  // namespace

std::optional<HeldSamples> FindHeldSamples(std::span<const double> time,
                                           std::span<const double> values) {
  const std::vector<EqualRun> runs = EqualRunsOf(values);
  if (runs.size() < kFewestRuns) return std::nullopt;
  std::vector<double> lengths, intervals, changes;
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) {
    lengths.push_back(static_cast<double>(runs[k].NumRows()));
    intervals.push_back(time[runs[k + 1].first] - time[runs[k].first]);
    changes.push_back(std::abs(values[runs[k + 1].first] - values[runs[k].first]));
  }
  const double usual = Median(lengths);
  std::size_t num_alone = 0, num_long = 0;
  for (const double length : lengths) {
    num_alone += length == 1.0;
    num_long += length > kLongRun * usual;
  }
  const auto num_values = static_cast<double>(lengths.size());
  const bool is_regular = static_cast<double>(num_alone) <= kMostAlone * num_values &&
                          static_cast<double>(num_long) <= kMostLong * num_values;
  if (usual < 2.0 || !is_regular) return std::nullopt;
  if (Median(changes) < kSeveral * Quantile(changes, kSmallestChange)) return std::nullopt;
  return HeldSamples{.interval = Median(intervals), .row_step = MedianStep(time)};
}

}  // namespace fathom
