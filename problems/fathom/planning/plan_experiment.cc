// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_experiment.h"

#include "fathom/planning/command_search.h"
#include "fathom/planning/drawn_models.h"
#include "fathom/planning/kept_limits.h"
#include "fathom/planning/leading_rival.h"
#include "fathom/planning/one_dof_judge.h"
#include "fathom/planning/plan_forecast.h"
#include "fathom/planning/plan_measures.h"
#include "fathom/planning/rival_separation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr int kNumModelsInSearch = 128;
constexpr int kNumModelsBesideRivals = 24;
constexpr int kNumModelsInCheck = 400;
constexpr double kWiderInSearch =
    1.5;  // the covariance of what is drawn: few models stand for rare ones
constexpr double kShareAllowed = 0.01;  // of the models that may break a limit
constexpr double kLargestPeriod = 0.1;  // of the stamps in the search [s]
constexpr int kMostStamps = 3000;

// Rivals take longer to tell apart than parameters.
constexpr int kNumStarts = 4;
constexpr int kNumStartsWithRivals = 2;
constexpr double kLongRun = 120.0;  // [s], from where on there are fewer: building takes the square
constexpr int kDrawnPerBlock = 40;
constexpr int kDrawnPerBlockWithRivals = 12;

// How many stamps are computed in all, so that planning takes seconds.
constexpr double kWork = 6e6;            // without rivals
constexpr double kWorkWithRivals = 6e6;  // over the runs that a measure takes
constexpr double kMostMoves = 8000.0;    // a short command needs no more

// The stamps of a run as it is measured, and the noise of a velocity at them; those at which it is
// held against limits, without and with the coast behind it.
struct RunStamps {
  double period = 0.0;
  std::vector<double> measured;
  StampNoise noise;
  std::vector<double> limits, limits_and_after;
};

// A velocity of the search stands for those measured in its period, and so does a position.
RunStamps StampsOf(const PlanRequest& request,
                   const VelocityMeasurement& measurement,
                   double duration) {
  RunStamps stamps;
  const double measured_period = 1.0 / measurement.rate;
  const double coarsest = std::max(kLargestPeriod, duration / kMostStamps);
  const int num_samples = std::max(1, static_cast<int>(std::round(coarsest / measured_period)));
  stamps.period = num_samples * measured_period;
  stamps.measured = PlannedStamps(duration, stamps.period);
  const double hold = request.limits.shortest_hold;
  stamps.limits = LimitStamps(hold, duration, coarsest);
  stamps.limits_and_after = LimitStamps(hold, duration + kCoastAfterwards, coarsest);
  stamps.noise = MeansOf(measurement.noise, ColourOf(request), num_samples);
  const PositionMeasurement& position = request.limits.position;
  const double position_rate = std::isnan(position.rate) ? measurement.rate : position.rate;
  stamps.noise.position = position.noise / std::sqrt(position_rate * stamps.period);
  return stamps;
}

// How much is searched, and along which axis.
CommandTask TaskOf(const PlanRequest& request, const RunStamps& stamps, double duration) {
  const Dof dof = request.model.dof;
  const double most = request.limits.force;
  CommandTask task;
  task.axes = {{dof,
                UsableForce(request.model.Extended(), dof, request.limits),
                std::clamp(request.model.model.buoyancy, -most, most)}};
  task.hold = request.limits.shortest_hold;
  task.duration = duration;
  task.seed = request.seed;
  const auto num_rivals = static_cast<double>(request.rivals.size());
  const double work =
      request.rivals.empty() ? kWork : kWorkWithRivals / (num_rivals * (num_rivals + 2.0));
  const double num_moves = std::min(kMostMoves, work / (duration / stamps.period));
  task.num_moves = static_cast<int>(request.effort * num_moves);
  const int most_starts = request.rivals.empty() ? kNumStarts : kNumStartsWithRivals;
  const double shorter = std::min(1.0, kLongRun / duration);
  task.num_starts = std::max(1, static_cast<int>(request.effort * shorter * most_starts));
  task.num_moves_of_start = task.num_moves / task.num_starts;
  task.drawn_per_block = request.rivals.empty() ? kDrawnPerBlock : kDrawnPerBlockWithRivals;
  return task;
}

// What is asked of commands.
OneDofQuestion QuestionOf(const PlanRequest& request, const RunStamps& stamps) {
  return {.dof = request.model.dof,
          .limits = request.limits,
          .stamps = stamps.measured,
          .limit_stamps = stamps.limits_and_after,
          .models = {},
          .measure = request.rivals.empty()
                         ? InformationMeasure(request, stamps.noise)
                         : SeparationMeasure(request, request.rivals, stamps.noise)};
}

// Fills the plan of a request with its leader. False if no command keeps the limits.
bool FillPlan(const PlanRequest& request, const RunStamps& stamps, ExperimentPlan* plan) {
  RandomStream random(request.seed, "planning.models");
  OneDofQuestion question = QuestionOf(request, stamps);
  FittedModel wider = request.model;
  wider.covariance *= kWiderInSearch;
  question.models = DrawModels(wider,
                               request.rivals.empty() ? kNumModelsInSearch : kNumModelsBesideRivals,
                               request.name,
                               random);
  const std::vector<ExtendedModel> others =
      DrawModels(request.model, kNumModelsInCheck, request.name, random);
  const int most = static_cast<int>(kShareAllowed * kNumModelsInCheck);
  const double hold = request.limits.shortest_hold;
  const auto command_of = [hold](const std::vector<WrenchBlock>& blocks) {
    return CommandOfCells(ForcesAlong(blocks, 0), hold);
  };
  CommandTask task = TaskOf(request, stamps, plan->duration);
  task.judge = [&](double share) { return OneDofJudge(question, share); };
  task.is_kept_by_others = [&](const std::vector<WrenchBlock>& blocks) {
    return NumBreaking(others,
                       question.dof,
                       command_of(blocks),
                       stamps.limits_and_after,
                       request.limits,
                       most) <= most;
  };
  FoundCommand found = SearchCommand(task);
  if (found.blocks.empty()) return false;
  plan->blocks = std::move(found.blocks);
  plan->force = task.axes.front().force;
  plan->command = command_of(plan->blocks);
  if (!ForecastMotion(request, others, stamps.limits_and_after, plan)) return false;
  plan->sine = LargestOrdinarySine(request, plan->duration, stamps.limits);
  ForecastParameters(request, others, stamps.measured, stamps.noise, plan);
  ForecastSeparations(request, request.rivals, stamps.measured, stamps.noise, plan);
  return true;
}

}  // namespace

ExperimentPlan PlanExperiment(const PlanRequest& asked) {
  RequirePlannable(asked);
  ExperimentPlan plan;
  plan.measurement = MeasurementOf(asked);
  const double hold = asked.limits.shortest_hold;
  plan.duration = hold * std::max(1.0, std::round(asked.duration / hold));
  const RunStamps stamps = StampsOf(asked, plan.measurement, plan.duration);

  const RunSetting log = {
      asked.model.dof, SineOfLog(asked, plan.duration), stamps.measured, stamps.noise};
  PlanRequest agreeing = asked;
  agreeing.rivals = AgreeingRivals(asked.rivals, log);

  // Under some causes no vehicle can be held in open loop: a stiffness below 0 drives it away.
  const std::size_t num_leaders = std::max<std::size_t>(1, agreeing.rivals.size());
  for (std::size_t leader = 0; leader < num_leaders; ++leader) {
    const auto request = LedByRival(agreeing, leader, log);
    if (!request || !FillPlan(*request, stamps, &plan)) continue;
    if (!request->rivals.empty()) plan.led_by = request->rivals.front().label;
    plan.message.clear();
    return plan;
  }
  plan.message = kNoCommandKeepsLimits;
  return plan;
}

}  // namespace fathom
