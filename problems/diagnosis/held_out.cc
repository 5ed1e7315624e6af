// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/held_out.h"

#include "fathom/simulate/extended_prediction.h"
#include "fathom/simulate/prediction.h"
#include "fathom/simulate/random_stream.h"

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

// Measured less predicted over the first seconds: the mean; and the straight line, at the first
// stamp and per second. 0 if there is nothing.
struct Miss {
  double mean = 0.0, first = 0.0, slope = 0.0;
};
Miss FirstMiss(const std::vector<double>& time,
               const std::vector<double>& measured,
               const std::vector<double>& predicted) {
  double n = 0.0, st = 0.0, stt = 0.0, sy = 0.0, sty = 0.0;
  for (size_t i = 0; i < time.size() && time[i] < time.front() + kStart; ++i) {
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

}  // namespace

std::optional<FreeRun> FreeRunOver(const Record& record, const ExtendedModel& model) {
  const EffectSimulation simulation(record.inputs.get(), record.stamps);
  InitialState start = record.initial;
  EffectOutputs outputs;
  const bool has_memory = !record.velocity.empty() && EffectSimulation::HasReadingMemory(model);
  for (int repeat = 0; repeat < 2; ++repeat) {
    if (has_memory) {
      const auto behind = StateBehind(model,
                                      *record.inputs,
                                      record.stamps.start,
                                      record.stamps.velocity,
                                      record.velocity,
                                      start);
      if (!behind) return std::nullopt;
      start = *behind;
    }
    if (!simulation.Run(model, start, &outputs)) return std::nullopt;
    const Miss in_velocity = FirstMiss(record.stamps.velocity, record.velocity, outputs.velocity);
    const Miss in_place =
        FirstMiss(record.stamps.displacement, record.displacement, outputs.displacement);
    // Without velocities the poses tell the first speed too.
    const bool by_poses = record.velocity.empty();
    if (!has_memory) start.velocity += by_poses ? in_place.slope : in_velocity.mean;
    start.position += by_poses ? in_place.first : in_place.mean;
  }
  return FreeRunOver(record, model, start);
}

std::optional<FreeRun> FreeRunOver(const Record& record,
                                   const ExtendedModel& model,
                                   const InitialState& initial) {
  EffectOutputs outputs;
  const EffectSimulation simulation(record.inputs.get(), record.stamps);
  if (!simulation.Run(model, initial, &outputs)) return std::nullopt;
  if (!record.velocity.empty()) {
    return FreeRun{record.stamps.velocity, record.velocity, std::move(outputs.velocity)};
  }
  return FreeRun{record.stamps.displacement, record.displacement, std::move(outputs.displacement)};
}

FitFigures FiguresOfRuns(std::span<const FreeRun> runs) {
  FigureSums sums;
  for (const FreeRun& run : runs) sums.Add(run.time, run.measured, run.predicted);
  return sums.Figures();
}

Gain GainOf(std::span<const FreeRun> before, std::span<const FreeRun> after, std::uint64_t seed) {
  const std::vector<BlockSums> blocks = SumsByBlock(before, after);
  if (blocks.empty()) return {std::nan(""), std::nan(""), std::nan("")};
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
  return {gain(all), gains[kNumResamples / 40], gains[kNumResamples - 1 - kNumResamples / 40]};
}

void Score(const std::vector<Record>& records,
           const ExtendedModel& before,
           const ExtendedModel& after,
           Scored* scored) {
  for (const Record& record : records) {
    auto run_before = FreeRunOver(record, before);
    auto run_after = FreeRunOver(record, after);
    if (!run_before || !run_after) continue;
    scored->before.push_back(std::move(*run_before));
    scored->after.push_back(std::move(*run_after));
  }
}

}  // namespace fathom
