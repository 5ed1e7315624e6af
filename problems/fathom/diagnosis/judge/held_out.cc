// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/held_out.h"

#include "fathom/diagnosis/judge/fitted_start.h"
#include "fathom/simulate/prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fathom {
namespace {

constexpr double kBlock = 10.0;  // [s], several times the vehicle's memory of an error
constexpr double kShortestBlock = 5.0;
constexpr double kWantedBlocks = 8.0;
constexpr size_t kFewestBlocks = 4;

struct BlockSums {
  double before = 0.0, after = 0.0;
};

// In blocks of so many seconds each.
std::vector<BlockSums> SumsByBlock(std::span<const FreeRun> before,
                                   std::span<const FreeRun> after,
                                   double length) {
  std::vector<BlockSums> blocks;
  for (size_t r = 0; r < before.size(); ++r) {
    double block_end = -1e300;
    for (size_t i = 0; i < before[r].time.size(); ++i) {
      if (before[r].time[i] >= block_end) {
        block_end = before[r].time[i] + length;
        blocks.emplace_back();
      }
      blocks.back().before += std::abs(before[r].predicted[i] - before[r].measured[i]);
      blocks.back().after += std::abs(after[r].predicted[i] - after[r].measured[i]);
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

// Measured less predicted, as a straight line: at the first stamp and per second. 0 if there is
// nothing.
struct Miss {
  double first = 0.0, slope = 0.0;
};
Miss MissOf(std::span<const double> time,
            std::span<const double> measured,
            std::span<const double> predicted) {
  double n = 0.0, st = 0.0, stt = 0.0, sy = 0.0, sty = 0.0;
  for (size_t i = 0; i < time.size(); ++i) {
    const double t = time[i] - time.front(), y = measured[i] - predicted[i];
    n += 1.0;
    st += t;
    stt += t * t;
    sy += y;
    sty += t * y;
  }
  if (n == 0.0) return {};
  const double spread = n * stt - st * st;
  const double slope = spread > 0.0 ? (n * sty - st * sy) / spread : 0.0;
  return {.first = (sy - slope * st) / n, .slope = slope};
}

std::optional<EffectOutputs> OutputsOver(const MeasuredSegment& segment,
                                         const ExtendedModel& model,
                                         const InitialState& initial) {
  EffectOutputs outputs;
  const EffectSimulation simulation(segment.inputs.get(), segment.stamps);
  if (!simulation.Run(model, initial, &outputs)) return std::nullopt;
  return outputs;
}

FreeRun RunOf(const MeasuredSegment& segment, EffectOutputs outputs) {
  if (!segment.velocity.empty()) {
    return {segment.stamps.velocity, segment.velocity, std::move(outputs.velocity)};
  }
  return {segment.stamps.displacement, segment.displacement, std::move(outputs.displacement)};
}

// The displacements, each block put onto the straight line that was measured.
FreeRun PosesByBlock(const MeasuredSegment& segment, const EffectOutputs& outputs) {
  FreeRun run{segment.stamps.displacement, segment.displacement, outputs.displacement};
  for (size_t begin = 0; begin < run.time.size();) {
    size_t end = begin;
    while (end < run.time.size() && run.time[end] < run.time[begin] + kBlock) ++end;
    const auto block = [&](const std::vector<double>& values) {
      return std::span(values).subspan(begin, end - begin);
    };
    const Miss miss = MissOf(block(run.time), block(run.measured), block(run.predicted));
    for (size_t i = begin; i < end; ++i) {
      run.predicted[i] += miss.first + miss.slope * (run.time[i] - run.time[begin]);
    }
    begin = end;
  }
  return run;
}

}  // namespace

std::optional<FreeRun> FreeRunOver(const MeasuredSegment& segment, const ExtendedModel& model) {
  const auto start = FittedStart(segment, model);
  if (!start) return std::nullopt;
  return FreeRunOver(segment, model, *start);
}

std::optional<FreeRun> PosesByBlock(const MeasuredSegment& segment, const ExtendedModel& model) {
  if (segment.velocity.empty() || segment.displacement.empty()) return std::nullopt;
  const auto start = FittedStart(segment, model);
  const auto outputs = start ? OutputsOver(segment, model, *start) : std::nullopt;
  if (!outputs) return std::nullopt;
  return PosesByBlock(segment, *outputs);
}

std::optional<FreeRun> FreeRunOver(const MeasuredSegment& segment,
                                   const ExtendedModel& model,
                                   const InitialState& initial) {
  auto outputs = OutputsOver(segment, model, initial);
  if (!outputs) return std::nullopt;
  return RunOf(segment, std::move(*outputs));
}

FitFigures FiguresOfRuns(std::span<const FreeRun> runs) {
  FigureSums sums;
  for (const FreeRun& run : runs) sums.Add(run.time, run.measured, run.predicted);
  return sums.Figures();
}

bool AreOverTheSame(std::span<const FreeRun> a, std::span<const FreeRun> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const FreeRun& x, const FreeRun& y) {
    return x.time == y.time;
  });
}

Gain GainOf(std::span<const FreeRun> before, std::span<const FreeRun> after) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<BlockSums> blocks = SumsByBlock(before, after, BlockLength(before));
  BlockSums all;
  for (const BlockSums& block : blocks) {
    all.before += block.before;
    all.after += block.after;
  }
  if (blocks.empty()) return {.value = kNone, .low = kNone, .high = kNone};
  const double left = all.after / all.before;
  const auto n = static_cast<double>(blocks.size());
  if (blocks.size() < kFewestBlocks) return {.value = 1.0 - left, .low = kNone, .high = kNone};
  double sum = 0.0, neighbours = 0.0, last = 0.0;
  for (const BlockSums& block : blocks) {
    const double apart = block.after - left * block.before;
    sum += apart * apart;
    neighbours += 2.0 * apart * last;
    last = apart;
  }
  // Neighbours share the errors about their edge.
  const double variance = std::max(sum, sum + neighbours) * n / (n - 1.0);
  const double std = std::sqrt(variance) / all.before;
  const double reach = StudentQuantile(n - 1.0) * std;
  return {.value = 1.0 - left, .low = 1.0 - left - reach, .high = 1.0 - left + reach};
}

Scored Score(const std::vector<MeasuredSegment>& segments,
             const ExtendedModel& before,
             const ExtendedModel& after) {
  Scored scored;
  for (const MeasuredSegment& segment : segments) {
    const auto outputs_of = [&](const ExtendedModel& model) -> std::optional<EffectOutputs> {
      const auto start = FittedStart(segment, model);
      if (!start) return std::nullopt;
      return OutputsOver(segment, model, *start);
    };
    auto outputs_before = outputs_of(before), outputs_after = outputs_of(after);
    if (!outputs_before || !outputs_after) continue;
    if (!segment.velocity.empty() && !segment.displacement.empty()) {
      scored.poses_before.push_back(PosesByBlock(segment, *outputs_before));
      scored.poses_after.push_back(PosesByBlock(segment, *outputs_after));
    }
    scored.before.push_back(RunOf(segment, std::move(*outputs_before)));
    scored.after.push_back(RunOf(segment, std::move(*outputs_after)));
  }
  return scored;
}

Gain GainOf(const Scored& scored, bool acts_on_poses_alone) {
  if (!acts_on_poses_alone || scored.poses_before.empty()) {
    return GainOf(scored.before, scored.after);
  }
  Gain gain = GainOf(scored.poses_before, scored.poses_after);
  gain.is_in_poses = true;
  return gain;
}

}  // namespace fathom
