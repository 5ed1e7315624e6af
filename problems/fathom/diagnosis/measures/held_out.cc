// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/held_out.h"

#include "fathom/simulate/effect_simulation.h"
#include "fathom/simulate/fitted_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fathom {
namespace {

constexpr double kBlock = 10.0;  // [s], of poses

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

MeasuredMotion MeasuredMotionOf(const MeasuredSegment& segment) {
  return {.start = segment.stamps.start,
          .velocity_time = segment.stamps.velocity,
          .velocity = segment.velocity,
          .displacement_time = segment.stamps.displacement,
          .displacement = segment.displacement};
}

std::optional<EffectOutputs> OutputsOver(const MeasuredSegment& segment,
                                         const ExtendedModel& model,
                                         const InitialState& initial) {
  EffectOutputs outputs;
  const EffectSimulation simulation(segment.inputs.get(), segment.stamps);
  if (!simulation.Run(model, initial, &outputs)) return std::nullopt;
  return outputs;
}

// What the sensors show in a free run.
std::optional<EffectOutputs> OutputsOver(const MeasuredSegment& segment,
                                         const ExtendedModel& model) {
  const auto start =
      FittedStart(model, *segment.inputs, MeasuredMotionOf(segment), segment.initial.position);
  if (!start) return std::nullopt;
  return OutputsOver(segment, model, *start);
}

// Displacements count from where the run begins: a model that never moves has an NMAE of 1,
// wherever the origin lies.
FreeRun RunOf(const MeasuredSegment& segment, EffectOutputs outputs) {
  if (!segment.velocity.empty()) {
    return {segment.stamps.velocity, segment.velocity, std::move(outputs.velocity), segment.log};
  }
  FreeRun run = {segment.stamps.displacement,
                 segment.displacement,
                 std::move(outputs.displacement),
                 segment.log};
  const double start = run.measured.front();
  for (double& value : run.measured) value -= start;
  for (double& value : run.predicted) value -= start;
  return run;
}

// The displacements, each block put onto the straight line that was measured.
FreeRun PosesByBlock(const MeasuredSegment& segment, const EffectOutputs& outputs) {
  FreeRun run{segment.stamps.displacement, segment.displacement, outputs.displacement, segment.log};
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
  auto outputs = OutputsOver(segment, model);
  if (!outputs) return std::nullopt;
  return RunOf(segment, *std::move(outputs));
}

std::optional<FreeRun> PosesByBlock(const MeasuredSegment& segment, const ExtendedModel& model) {
  if (segment.velocity.empty() || segment.displacement.empty()) return std::nullopt;
  const auto outputs = OutputsOver(segment, model);
  if (!outputs) return std::nullopt;
  return PosesByBlock(segment, *outputs);
}

std::optional<FreeRun> RunFrom(const InitialState& initial,
                               const MeasuredSegment& segment,
                               const ExtendedModel& model) {
  auto outputs = OutputsOver(segment, model, initial);
  if (!outputs) return std::nullopt;
  return RunOf(segment, *std::move(outputs));
}

bool AreOverTheSame(std::span<const FreeRun> a, std::span<const FreeRun> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const FreeRun& x, const FreeRun& y) {
    return x.time == y.time;
  });
}

Scored Score(const std::vector<MeasuredSegment>& segments,
             const ExtendedModel& before,
             const ExtendedModel& after) {
  Scored scored;
  for (const MeasuredSegment& segment : segments) {
    auto outputs_before = OutputsOver(segment, before);
    auto outputs_after = OutputsOver(segment, after);
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

Scored Beside(const Scored& stood, const Scored& tried) {
  Scored beside;
  beside.by_log = tried.by_log;
  const auto put =
      [](const std::vector<FreeRun>& a, const std::vector<FreeRun>& b, auto* into_a, auto* into_b) {
        for (const FreeRun& run : a) {
          const auto same = std::find_if(b.begin(), b.end(), [&](const FreeRun& other) {
            return other.log == run.log && other.time == run.time;
          });
          if (same == b.end()) continue;
          into_a->push_back(run);
          into_b->push_back(*same);
        }
      };
  put(stood.after, tried.after, &beside.before, &beside.after);
  put(stood.poses_after, tried.poses_after, &beside.poses_before, &beside.poses_after);
  return beside;
}

Gain GainOf(const Scored& scored, bool acts_on_poses_alone) {
  const auto gain_of = [&](const std::vector<FreeRun>& before, const std::vector<FreeRun>& after) {
    return scored.by_log ? GainOverLogs(before, after) : GainOf(before, after);
  };
  if (!acts_on_poses_alone || scored.poses_before.empty()) {
    return gain_of(scored.before, scored.after);
  }
  Gain gain = gain_of(scored.poses_before, scored.poses_after);
  gain.is_in_poses = true;
  return gain;
}

}  // namespace fathom
