// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/held_out.h"

#include "fathom/base/random_stream.h"
#include "fathom/simulate/prediction.h"
#include "fathom/simulate/run_start.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr double kBlock = 10.0;  // [s], several times the vehicle's memory of an error
constexpr double kStart = 2.0;   // [s], over which a run is made to begin as measured
constexpr int kNumResamples = 2000;

struct BlockSums {
  double before = 0.0, after = 0.0;
};

std::vector<BlockSums> SumsByBlock(std::span<const FreeRun> before,
                                   std::span<const FreeRun> after) {
  std::vector<BlockSums> blocks;
  for (size_t r = 0; r < before.size(); ++r) {
    double block_end = -1e300;
    for (size_t i = 0; i < before[r].time.size(); ++i) {
      if (before[r].time[i] >= block_end) {
        block_end = before[r].time[i] + kBlock;
        blocks.emplace_back();
      }
      blocks.back().before += std::abs(before[r].predicted[i] - before[r].measured[i]);
      blocks.back().after += std::abs(after[r].predicted[i] - after[r].measured[i]);
    }
  }
  return blocks;
}

// Measured less predicted: the mean; and the straight line, at the first stamp and per second. 0 if
// there is nothing.
struct Miss {
  double mean = 0.0, first = 0.0, slope = 0.0;
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
  return {.mean = sy / n, .first = (sy - slope * st) / n, .slope = slope};
}

// Over the first seconds.
Miss FirstMiss(const std::vector<double>& time,
               const std::vector<double>& measured,
               const std::vector<double>& predicted) {
  if (time.empty()) return {};
  const auto end = std::lower_bound(time.begin(), time.end(), time.front() + kStart);
  const auto n = static_cast<size_t>(end - time.begin());
  return MissOf(
      std::span(time).first(n), std::span(measured).first(n), std::span(predicted).first(n));
}

// The state from which a run over the segment begins as measured; see FreeRunOver().
std::optional<InitialState> StartOver(const MeasuredSegment& segment, const ExtendedModel& model) {
  const EffectSimulation simulation(segment.inputs.get(), segment.stamps);
  InitialState start = segment.initial;
  EffectOutputs outputs;
  const bool has_memory = !segment.velocity.empty() && EffectSimulation::HasReadingMemory(model);
  for (int repeat = 0; repeat < 2; ++repeat) {
    if (has_memory) {
      const auto behind = StateBehind(model,
                                      *segment.inputs,
                                      segment.stamps.start,
                                      segment.stamps.velocity,
                                      segment.velocity,
                                      start);
      if (!behind) return std::nullopt;
      start = *behind;
    }
    if (!simulation.Run(model, start, &outputs)) return std::nullopt;
    const Miss in_velocity = FirstMiss(segment.stamps.velocity, segment.velocity, outputs.velocity);
    const Miss in_place =
        FirstMiss(segment.stamps.displacement, segment.displacement, outputs.displacement);
    // Without velocities the poses tell the first speed too.
    const bool by_poses = segment.velocity.empty();
    if (!has_memory) start.velocity += by_poses ? in_place.slope : in_velocity.mean;
    start.position += by_poses ? in_place.first : in_place.mean;
  }
  return start;
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
  const auto start = StartOver(segment, model);
  if (!start) return std::nullopt;
  return FreeRunOver(segment, model, *start);
}

std::optional<FreeRun> PosesByBlock(const MeasuredSegment& segment, const ExtendedModel& model) {
  if (segment.velocity.empty() || segment.displacement.empty()) return std::nullopt;
  const auto start = StartOver(segment, model);
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

Gain GainOf(std::span<const FreeRun> before, std::span<const FreeRun> after, std::uint64_t seed) {
  const std::vector<BlockSums> blocks = SumsByBlock(before, after);
  if (blocks.empty()) {
    return {.value = std::nan(""), .low = std::nan(""), .high = std::nan("")};
  }
  const auto gain = [](const BlockSums& sums) { return 1.0 - sums.after / sums.before; };
  BlockSums all;
  for (const BlockSums& block : blocks) {
    all.before += block.before;
    all.after += block.after;
  }
  RandomStream random(seed, "diagnosis.gain");
  std::vector<double> gains;
  for (int k = 0; k < kNumResamples; ++k) {
    BlockSums sums;
    for (size_t i = 0; i < blocks.size(); ++i) {
      const auto pick =
          std::min(blocks.size() - 1,
                   static_cast<size_t>(random.Uniform() * static_cast<double>(blocks.size())));
      sums.before += blocks[pick].before;
      sums.after += blocks[pick].after;
    }
    gains.push_back(gain(sums));
  }
  std::sort(gains.begin(), gains.end());
  return {.value = gain(all),
          .low = gains[kNumResamples / 40],
          .high = gains[kNumResamples - 1 - kNumResamples / 40]};
}

Scored Score(const std::vector<MeasuredSegment>& segments,
             const ExtendedModel& before,
             const ExtendedModel& after) {
  Scored scored;
  for (const MeasuredSegment& segment : segments) {
    const auto outputs_of = [&](const ExtendedModel& model) -> std::optional<EffectOutputs> {
      const auto start = StartOver(segment, model);
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

Gain GainOf(const Scored& scored, bool acts_on_poses_alone, std::uint64_t seed) {
  if (!acts_on_poses_alone || scored.poses_before.empty()) {
    return GainOf(scored.before, scored.after, seed);
  }
  Gain gain = GainOf(scored.poses_before, scored.poses_after, seed);
  gain.is_in_poses = true;
  return gain;
}

}  // namespace fathom
