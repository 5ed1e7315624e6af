// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/free_run.h"

#include "fathom/base/not_known.h"
#include "fathom/simulate/fitted_start.h"
#include "fathom/simulate/prediction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace fathom {
namespace {

constexpr double kBlock = 10.0;  // [s], several times the vehicle's memory of an error
constexpr double kShortestBlock = 5.0;
constexpr double kWantedBlocks = 8.0;
constexpr size_t kFewestBlocks = 4;

// |miss| of two models, summed.
struct ErrorSums {
  double before = 0.0, after = 0.0;

  void Add(const FreeRun& first, const FreeRun& second, std::size_t i) {
    before += std::abs(first.predicted[i] - first.measured[i]);
    after += std::abs(second.predicted[i] - second.measured[i]);
  }
};

// In blocks of so many seconds each.
std::vector<ErrorSums> SumsByBlock(std::span<const FreeRun> before,
                                   std::span<const FreeRun> after,
                                   double length) {
  std::vector<ErrorSums> blocks;
  for (size_t r = 0; r < before.size(); ++r) {
    double block_end = -1e300;
    for (size_t i = 0; i < before[r].time.size(); ++i) {
      if (before[r].time[i] >= block_end) {
        block_end = before[r].time[i] + length;
        blocks.emplace_back();
      }
      blocks.back().Add(before[r], after[r], i);
    }
  }
  return blocks;
}

// Of blocks [s]: shorter ones where the runs are short.
double BlockLength(std::span<const FreeRun> runs) {
  double total = 0.0;
  for (const FreeRun& run : runs) {
    if (!run.time.empty()) total += run.time.back() - run.time.front();
  }
  return std::clamp(total / kWantedBlocks, kShortestBlock, kBlock);
}

// Student's t at 97.5 %, by degrees of freedom: Cornish-Fisher's expansion about the normal
// quantile, which is right to 1 % from three on; Abramowitz, Stegun, 26.7.5.
double StudentQuantile(double freedom) {
  constexpr double z = 1.959963985;
  if (freedom < 2.0) return 12.706;
  if (freedom < 3.0) return 4.303;
  constexpr double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4.0 * freedom) +
         (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * freedom * freedom) +
         (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * freedom * freedom * freedom);
}

// 1 - sum after / sum before, with an interval over the units, NaN from fewer than `fewest`.
// `share_edges`: neighbours share the errors about their edge.
Gain GainOfSums(const std::vector<ErrorSums>& units, std::size_t fewest, bool share_edges) {
  ErrorSums all;
  for (const ErrorSums& unit : units) {
    all.before += unit.before;
    all.after += unit.after;
  }
  if (units.empty()) return {.value = kNotKnown, .low = kNotKnown, .high = kNotKnown};
  const double left = all.after / all.before;
  const auto n = static_cast<double>(units.size());
  if (units.size() < fewest) return {.value = 1.0 - left, .low = kNotKnown, .high = kNotKnown};
  double sum = 0.0, neighbours = 0.0, last = 0.0;
  for (const ErrorSums& unit : units) {
    const double apart = unit.after - left * unit.before;
    sum += apart * apart;
    neighbours += 2.0 * apart * last;
    last = apart;
  }
  const double variance = (share_edges ? std::max(sum, sum + neighbours) : sum) * n / (n - 1.0);
  const double reach = StudentQuantile(n - 1.0) * std::sqrt(variance) / all.before;
  // No error falls below zero.
  const double high = std::min(1.0, 1.0 - left + reach);
  return {.value = 1.0 - left, .low = 1.0 - left - reach, .high = high};
}

}  // namespace

std::optional<FreeRun> FreeRunOver(const Segment& segment,
                                   const ExtendedModel& model,
                                   double position,
                                   const EffectInputs* inputs) {
  const EffectInputs own = inputs == nullptr ? CommandOnly(segment) : EffectInputs();
  if (inputs == nullptr) inputs = &own;
  const auto start = FittedStart(model, *inputs, MotionOf(segment), position);
  auto predicted = start ? Predict(model, segment, *start, inputs) : std::nullopt;
  if (!predicted) return std::nullopt;
  return FreeRun{segment.time, segment.velocity, *std::move(predicted)};
}

FitFigures FiguresOfRuns(std::span<const FreeRun> runs) {
  FigureSums sums;
  for (const FreeRun& run : runs) sums.Add(run.time, run.measured, run.predicted);
  return sums.Figures();
}

FitFigures FiguresOf(const ExtendedModel& model, std::span<const Segment> segments) {
  FigureSums sums;
  for (const Segment& segment : segments) {
    const auto run = FreeRunOver(segment, model);
    if (!run) return {};
    sums.Add(run->time, run->measured, run->predicted);
  }
  return sums.Figures();
}

Gain GainOf(std::span<const FreeRun> before, std::span<const FreeRun> after) {
  const std::vector<ErrorSums> blocks = SumsByBlock(before, after, BlockLength(before));
  return GainOfSums(blocks, kFewestBlocks, true);
}

Gain GainOverLogs(std::span<const FreeRun> before, std::span<const FreeRun> after) {
  std::map<std::string, ErrorSums> by_log;
  for (std::size_t r = 0; r < before.size(); ++r) {
    ErrorSums& sums = by_log[before[r].log];
    for (std::size_t i = 0; i < before[r].time.size(); ++i) sums.Add(before[r], after[r], i);
  }
  std::vector<ErrorSums> logs;
  for (const auto& [name, sums] : by_log) logs.push_back(sums);
  Gain gain = GainOfSums(logs, 2, false);
  gain.num_logs = logs.size();
  gain.num_better = std::count_if(
      logs.begin(), logs.end(), [](const ErrorSums& log) { return log.after < log.before; });
  return gain;
}

}  // namespace fathom
