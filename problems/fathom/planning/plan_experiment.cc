// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_experiment.h"

#include "fathom/planning/drawn_models.h"
#include "fathom/planning/plan_forecast.h"
#include "fathom/planning/plan_measures.h"
#include "fathom/planning/plan_search.h"
#include "fathom/planning/rival_separation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr int kNumModelsInSearch = 64;
constexpr int kNumModelsBesideRivals = 24;
constexpr int kNumModelsInCheck = 400;
constexpr double kShareAllowed = 0.05;  // of the models that may break a limit
constexpr int kNumTrials = 6;           // with limits narrower from one to the next
constexpr double kNarrower = 0.95;
constexpr double kLargestPeriod = 0.1;  // of the stamps in the search [s]
constexpr int kMostStamps = 3000;

// How many stamps are computed in all, so that planning takes seconds.
constexpr double kWork = 9.6e6;          // without rivals
constexpr double kWorkWithRivals = 5e6;  // over the runs that a measure takes
constexpr double kMostMoves = 8000.0;    // a short command needs no more

}  // namespace

ExperimentPlan PlanExperiment(const PlanRequest& request) {
  RequirePlannable(request);
  ExperimentPlan plan;
  plan.measurement = MeasurementOf(request);
  const double hold = request.limits.shortest_hold;
  plan.duration = hold * std::max(1.0, std::round(request.duration / hold));

  // A velocity of the search stands for those measured in its period.
  const double measured_period = 1.0 / plan.measurement.rate;
  const double period = std::max({measured_period, kLargestPeriod, plan.duration / kMostStamps});
  const double noise = plan.measurement.noise * std::sqrt(measured_period / period);
  const std::vector<double> stamps = PlannedStamps(plan.duration, period);

  RandomStream random(request.seed, "planning.models");
  const std::vector<RivalModel> rivals = AgreeingRivals(
      request.rivals, {request.model.dof, SineOfLog(request, plan.duration), stamps, noise});
  const std::vector<ExtendedModel> models =
      DrawModels(request.model,
                 rivals.empty() ? kNumModelsInSearch : kNumModelsBesideRivals,
                 request.name,
                 random);
  const std::vector<ExtendedModel> others =
      DrawModels(request.model, kNumModelsInCheck, request.name, random);

  CommandTask task;
  task.dof = request.model.dof;
  task.limits = request.limits;
  task.duration = plan.duration;
  task.period = period;
  task.models = models;
  task.seed = request.seed;
  task.holding_force =
      std::clamp(request.model.model.buoyancy, -request.limits.force, request.limits.force);
  const auto num_rivals = static_cast<double>(rivals.size());
  const double work = rivals.empty() ? kWork : kWorkWithRivals / (num_rivals * (num_rivals + 2.0));
  const double num_moves = std::min(kMostMoves, work / static_cast<double>(stamps.size()));
  task.num_moves = static_cast<int>(request.effort * num_moves);
  task.measure = rivals.empty() ? InformationMeasure(request, noise)
                                : SeparationMeasure(request, rivals, noise);
  for (int trial = 0; trial < kNumTrials; ++trial) {
    FoundCommand found = SearchCommand(task);
    if (found.blocks.empty()) break;
    plan.blocks = std::move(found.blocks);
    plan.command = CommandOfCells(ForcesOf(plan.blocks), hold);
    if (!ForecastMotion(request, others, stamps, &plan)) break;
    if (plan.share_breaking <= kShareAllowed) {
      plan.sine = LargestOrdinarySine(request, plan.duration, stamps);
      ForecastParameters(request, stamps, noise, &plan);
      ForecastSeparations(request, rivals, stamps, noise, &plan);
      plan.message.clear();
      return plan;
    }
    task.limits.speed *= kNarrower;
    task.limits.distance.low *= kNarrower;
    task.limits.distance.high *= kNarrower;
  }
  plan.message =
      "No command was found that keeps the limits for 95 % of the models that the log allows. Give "
      "it more room, less time, or a model of narrower intervals.";
  return plan;
}

}  // namespace fathom
