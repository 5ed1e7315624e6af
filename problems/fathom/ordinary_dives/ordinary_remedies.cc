// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/ordinary_remedies.h"

#include "fathom/base/interval95.h"
#include "fathom/ordinary_dives/simple_manoeuvres.h"
#include "fathom/planning/experiment_plan.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kFaster = 4.0;  // times the rate
constexpr int kMostMinutes = 10;
constexpr double kManoeuvreLength = 60.0;  // [s]

// Half the weakest parameter's interval by its size.
double ShareBy(const RemedyTask& task, const RunNormal& normal) {
  const std::size_t weakest = task.dives.all.weakest;
  const double std = KnowledgeBy(normal.Information(), task.dives.parameters).stds[weakest];
  return kStdsOf95 * std / task.dives.parameters[weakest].size;
}

// All logs, and this so many times.
RunNormal Beside(const RemedyTask& task, const RunNormal& more, double times) {
  RunNormal sum = task.of_all;
  sum.Add(more, times);
  return sum;
}

// The manoeuvre that helps most beside all logs; without words if none can be run.
Remedy BestManoeuvre(const RemedyTask& task) {
  const std::vector<double> stamps = PlannedStamps(kManoeuvreLength, 1.0 / task.dives.rate);
  Remedy best = {RemedyKind::kManoeuvre, "", std::numeric_limits<double>::infinity()};
  for (const SimpleManoeuvre& manoeuvre :
       SimpleManoeuvres(task.request.model, task.reach.force, task.reach.speed, kManoeuvreLength)) {
    MotionDerivatives derivatives;
    if (!MotionUnder(task.request.model.Extended(),
                     task.request.model.dof,
                     manoeuvre.command,
                     stamps,
                     &derivatives)) {
      continue;
    }
    const RunNormal more = NormalOfRun(derivatives, stamps, task.places, task.noise);
    const double share = ShareBy(task, Beside(task, more, 1.0));
    if (!(share < best.share)) continue;
    best.share = share;
    best.words = fmt::format("drive for a minute: {}", manoeuvre.words);
    best.minutes = 0;
    for (int minutes = kMostMinutes; minutes >= 1; --minutes) {
      const double known = ShareBy(task, Beside(task, more, minutes));
      if (known <= OrdinaryDives::kWellKnown) best.minutes = minutes;
    }
  }
  return best;
}

Remedy PositionRemedy(const RemedyTask& task) {
  const double noise = AdvisedPositionNoise(task.request.model.dof);
  RunNoise of_positions;
  of_positions.is_position = true;
  of_positions.noise.velocity = noise;
  RunNormal sum = RunNormal::Zero(task.of_all.A.rows());
  for (std::size_t s = 0; s < task.runs.size(); ++s) {
    sum.Add(NormalOfRun(
        task.runs[s].derivatives, task.request.segments[s].time, task.places, of_positions));
  }
  return {
      RemedyKind::kPosition,
      fmt::format("record the position too, as by a camera and markers, known to {:g} {} at each "
                  "velocity, and fit to it",
                  noise,
                  DisplacementUnit(task.request.model.dof)),
      ShareBy(task, sum)};
}

}  // namespace

std::vector<Remedy> RemediesFor(const RemedyTask& task) {
  std::vector<Remedy> remedies = {{RemedyKind::kMoreOfTheSame,
                                   "record as much again of the same dives",
                                   ShareBy(task, Beside(task, task.of_all, 1.0))}};
  if (Remedy manoeuvre = BestManoeuvre(task); !manoeuvre.words.empty()) {
    remedies.push_back(std::move(manoeuvre));
  }
  if (task.dives.neighbour_correlation < OrdinaryDives::kAlike) {
    if (!task.noise.is_position) remedies.push_back(PositionRemedy(task));
    remedies.push_back({RemedyKind::kFasterRate,
                        fmt::format("record the {} at {:.3g} Hz instead of {:.3g} Hz",
                                    task.noise.is_position ? "poses" : "velocities",
                                    kFaster * task.dives.rate,
                                    task.dives.rate),
                        ShareBy(task, Beside(task, task.of_all, kFaster - 1.0))});
  }
  std::ranges::stable_sort(remedies, {}, &Remedy::share);
  return remedies;
}

}  // namespace fathom
