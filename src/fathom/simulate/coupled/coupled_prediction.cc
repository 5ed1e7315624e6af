// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_prediction.h"

#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/simulate/coupled/coupled_start.h"
#include "fathom/simulate/prediction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

constexpr double kPositionAfter = 10.0;  // [s]

// How far off positions are, over several runs.
struct PositionMisses {
  double sum_of_squares = 0.0;
  int num = 0;

  void Add(const CoupledSegment& segment,
           double start,
           const CoupledOutputs& outputs,
           std::size_t first_pose) {
    // Of the first pose from then on.
    for (std::size_t k = 0; k < outputs.pose.size(); ++k) {
      if (segment.pose_time[first_pose + k] < start + kPositionAfter) continue;
      const Eigen::Vector3d miss = outputs.pose[k].position - segment.position[first_pose + k];
      double squares = 0.0;
      for (const double along : miss) squares += std::isfinite(along) ? along * along : 0.0;
      sum_of_squares += squares;
      ++num;
      return;
    }
  }
};

struct DofSums {
  FigureSums all, train, held_out;
};

void AddFigures(const CoupledSegment& segment,
                const std::vector<Vector6>& predicted,
                Dof dof,
                DofSums* sums) {
  const FreeRun run = FreeRunAlong(dof, segment, {0, segment.time.size()}, predicted);
  if (run.time.empty()) return;
  sums->all.Add(run.time, run.measured, run.predicted);
  (segment.is_held_out ? sums->held_out : sums->train).Add(run.time, run.measured, run.predicted);
}

// False if a run diverges.
bool RunSegment(const CoupledModel& model,
                const CoupledData& log,
                const CoupledSegment& segment,
                double horizon,
                std::vector<Vector6>* predicted,
                PositionMisses* misses) {
  const bool has_position =
      std::any_of(log.has_position.begin(), log.has_position.end(), [](bool has) { return has; });
  for (const SampleWindow& window : WindowsOf(segment, horizon)) {
    CoupledStamps stamps;
    const auto begin = segment.time.begin();
    stamps.velocity.assign(begin + static_cast<std::ptrdiff_t>(window.begin),
                           begin + static_cast<std::ptrdiff_t>(window.end));
    stamps.start = stamps.velocity.front();
    const auto from =
        std::lower_bound(segment.pose_time.begin(), segment.pose_time.end(), stamps.start);
    const auto to = std::upper_bound(from, segment.pose_time.end(), stamps.velocity.back());
    if (has_position) stamps.pose.assign(from, to);
    CoupledOutputs outputs;
    const CoupledState start = FittedCoupledStart(model, log, segment, window.begin);
    if (!RunCoupled(model, log.inputs, start, stamps, &outputs)) return false;
    predicted->insert(predicted->end(), outputs.velocity.begin(), outputs.velocity.end());
    misses->Add(
        segment, stamps.start, outputs, static_cast<std::size_t>(from - segment.pose_time.begin()));
  }
  return true;
}

}  // namespace

std::optional<CoupledPrediction> PredictCoupled(const CoupledModel& model,
                                                std::span<const CoupledData> logs,
                                                double horizon) {
  CoupledPrediction prediction;
  std::array<DofSums, 6> sums;
  PositionMisses misses;
  for (const CoupledData& log : logs) {
    auto& of_log = prediction.velocity.emplace_back();
    for (const CoupledSegment& segment : log.segments) {
      of_log.emplace_back();
      if (!RunSegment(model, log, segment, horizon, &of_log.back(), &misses)) return std::nullopt;
      for (const Dof dof : model.dofs) {
        AddFigures(segment, of_log.back(), dof, &sums[static_cast<std::size_t>(Index(dof))]);
      }
    }
  }
  for (const Dof dof : model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    prediction.figures[at] = sums[at].all.Figures();
    prediction.train[at] = sums[at].train.Figures();
    prediction.held_out[at] = sums[at].held_out.Figures();
  }
  if (misses.num > 0) prediction.position_error = std::sqrt(misses.sum_of_squares / misses.num);
  return prediction;
}

FreeRun FreeRunAlong(Dof dof,
                     const CoupledSegment& segment,
                     const SampleWindow& samples,
                     std::span<const Vector6> predicted) {
  FreeRun run;
  for (std::size_t i = samples.begin; i < samples.end; ++i) {
    const double measured = segment.velocity[i][Index(dof)];
    if (!std::isfinite(measured)) continue;
    run.time.push_back(segment.time[i]);
    run.measured.push_back(measured);
    run.predicted.push_back(predicted[i - samples.begin][Index(dof)]);
  }
  return run;
}

std::vector<FreeRun> FreeRunsAlong(Dof dof,
                                   std::span<const CoupledData> logs,
                                   const CoupledPrediction& prediction) {
  std::vector<FreeRun> runs;
  for (std::size_t k = 0; k < logs.size(); ++k) {
    for (std::size_t s = 0; s < logs[k].segments.size(); ++s) {
      const CoupledSegment& segment = logs[k].segments[s];
      runs.push_back(
          FreeRunAlong(dof, segment, {0, segment.time.size()}, prediction.velocity[k][s]));
    }
  }
  return runs;
}

}  // namespace fathom
