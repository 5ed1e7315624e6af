// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/plan_coupled.h"

#include "fathom/base/input_error.h"
#include "fathom/base/parallel_for.h"
#include "fathom/coupled_planning/axis_sines.h"
#include "fathom/coupled_planning/coupled_forecast.h"
#include "fathom/coupled_planning/coupled_noise.h"
#include "fathom/coupled_planning/drawn_coupled_models.h"
#include "fathom/coupled_planning/flown_entries.h"
#include "fathom/coupled_planning/kept_wrench.h"
#include "fathom/coupled_planning/wrench_judge.h"
#include "fathom/coupled_planning/wrench_run.h"
#include "fathom/coupled_planning/wrench_thrusters.h"
#include "fathom/planning/command_search.h"
#include "fathom/planning/information.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr int kNumCoupledInSearch = 20;
constexpr int kNumCoupledInForecast = 9;  // the fit's own along
constexpr int kNumCoupledInCheck = 200;
constexpr double kShareOfCoupled = 0.05;  // of the models that may break a limit
constexpr int kNumCoupledStarts = 2;
constexpr int kCoupledPerBlock = 8;         // of which the best is taken
constexpr int kCoupledMovesOverStarts = 5;  // moves of the best start over those of each
constexpr double kWeightSoFar = 0.03;       // w of docs/plan.md (2)

// How many columns of sensitivities are integrated in all, so that planning takes seconds.
constexpr double kCoupledWork = 7e5;  // [s]
constexpr double kMostCoupledMoves = 400.0;

bool Has(const std::vector<Dof>& dofs, Dof dof) {
  return std::find(dofs.begin(), dofs.end(), dof) != dofs.end();
}

double LimitOf(const std::array<double, 6>& by_dof, Dof dof) {
  return by_dof[static_cast<std::size_t>(Index(dof))];
}

// What keeps an upright vehicle where it is.
double HoldingForce(const CoupledModel& model, Dof dof) {
  return model.offset[Index(dof)] + (dof == Dof::kHeave ? model.net_buoyancy : 0.0);
}

// "surge, sway, yaw".
std::string ModelledNames(const CoupledPlanRequest& request) {
  std::vector<std::string_view> names;
  for (const Dof dof : request.model.model.dofs) names.push_back(Name(dof));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<WrenchAxis> AxesOf(const CoupledPlanRequest& request) {
  const CoupledLimits& limits = request.limits;
  std::vector<WrenchAxis> axes;
  for (const Dof dof : kAllDofs) {
    const double force = LimitOf(limits.force, dof);
    const bool is_modelled = Has(request.model.model.dofs, dof);
    const bool limits_speed = std::isfinite(LimitOf(limits.speed, dof));
    if ((force > 0.0 || limits_speed) && !is_modelled) {
      throw InputError(
          fmt::format("{}: key '{}' holds {}, which {} does not model, expected of {}.",
                      request.limits_name,
                      force > 0.0 ? "force" : "speed",
                      Name(dof),
                      request.name,
                      ModelledNames(request)));
    }
    if (request.dofs.empty() ? force == 0.0 : !Has(request.dofs, dof)) continue;
    if (!is_modelled) {
      throw InputError(fmt::format("--dofs: names {}, which {} does not model, expected of {}.",
                                   Name(dof),
                                   request.name,
                                   ModelledNames(request)));
    }
    if (force == 0.0) {
      throw InputError(fmt::format(
          "{}: key 'force' lacks {}, which --dofs names, expected how much may be commanded [{}].",
          request.limits_name,
          Name(dof),
          ForceUnit(dof)));
    }
    axes.push_back({dof, force, std::clamp(HoldingForce(request.model.model, dof), -force, force)});
  }
  if (!axes.empty()) return axes;
  throw InputError(fmt::format(
      "{}: key 'force' names no DOF, expected one to command at the least.", request.limits_name));
}

// Numbers of thrusters and fins, of which a wrench tells nothing, the current of another run, and
// what two clocks differ by.
bool IsLeftOut(const FreeEntry& entry) {
  return !entry.actuator.empty() || entry.kind == FreeEntry::Kind::kThrusterEffect ||
         entry.kind == FreeEntry::Kind::kTimeOffset;
}

ToldEntries EntriesToTell(const CoupledPlanRequest& request, const CoupledPlan& plan) {
  const FittedCoupledModel& fitted = request.model;
  ToldEntries told;
  std::vector<Eigen::Index> rows;
  for (std::size_t k = 0; k < fitted.entries.size(); ++k) {
    if (IsLeftOut(fitted.entries[k])) continue;
    told.entries.push_back(fitted.entries[k]);
    rows.push_back(static_cast<Eigen::Index>(k));
  }
  if (told.entries.empty()) {
    throw InputError(fmt::format(
        "{}: holds no identified number that a wrench tells of, expected one: of single "
        "thrusters, fins and clocks it tells nothing. fathom_identify --dofs writes it.",
        request.name));
  }
  told.covariance = fitted.covariance(rows, rows);
  told.flown = FlownInformation(request, plan, told.entries);
  return told;
}

// The rivals of the request, both ways. The sines stand for the log so far, which is not at hand.
void AddRivals(const CoupledPlanRequest& request,
               const CoupledPlan& plan,
               WrenchQuestion* question) {
  if (request.rivals.empty()) return;
  question->rivals = PlaceRivals(request.rivals, &question->entries);
  WrenchInformation information(request.model.model, question->entries, question->measurement);
  const auto of_sines = information.Of(plan.sine, plan.duration);
  if (of_sines) question->rivals = BothWays(question->rivals, question->so_far.rows(), *of_sines);
}

// What is asked of commands.
WrenchQuestion QuestionOfWrench(const CoupledPlanRequest& request,
                                const CoupledPlan& plan,
                                const ToldEntries& told) {
  WrenchQuestion question;
  question.axes = plan.axes;
  question.thrusters = plan.thrusters;
  question.limits = request.limits;
  question.duration = plan.duration;
  question.entries = told.entries;
  question.so_far = kWeightSoFar * InverseOf(told.covariance) + told.flown;
  question.measurement = MeasurementFor(request, plan);
  AddRivals(request, plan, &question);
  return question;
}

// How much is searched.
CommandTask TaskOfWrench(const CoupledPlanRequest& request, const WrenchQuestion& question) {
  const auto num_columns =
      static_cast<double>(NumCoupledColumns(request.model.model, question.entries));
  const double moves =
      std::min(kMostCoupledMoves, kCoupledWork / (question.duration * num_columns));
  CommandTask task;
  task.axes = question.axes;
  task.hold = request.limits.shortest_hold;
  task.duration = question.duration;
  task.num_starts = kNumCoupledStarts;
  task.drawn_per_block = kCoupledPerBlock;
  task.num_moves = std::max(10, static_cast<int>(request.effort * moves));
  task.num_moves_of_start = task.num_moves / kCoupledMovesOverStarts;
  task.seed = request.seed;
  return task;
}

// Halves the force of an axis until one hold of it, and the coast behind, keeps the limits: what is
// more is of no use.
void TakeUsableForces(const CoupledModel& model,
                      const CoupledLimits& limits,
                      std::vector<WrenchAxis>* axes) {
  constexpr int kMostHalvings = 40;
  const std::vector<double> stamps = WrenchLimitStamps(limits.shortest_hold, limits.shortest_hold);
  Vector6 holding = Vector6::Zero();
  for (const WrenchAxis& axis : *axes) holding[Index(axis.dof)] = axis.holding;
  for (WrenchAxis& axis : *axes) {
    const auto keeps = [&](double sign) {
      CoupledCommand command;
      command.time = {0.0, limits.shortest_hold};
      command.force = {holding, holding};
      command.force[0][Index(axis.dof)] = sign * axis.force;
      const auto run = WrenchMotion(model, command, stamps);
      return run && KeepsLimits(*run, limits);
    };
    for (int i = 0; i < kMostHalvings && !keeps(1.0) && !keeps(-1.0); ++i) axis.force *= 0.5;
  }
}

// Whether nearly all models keep the limits under a command.
bool AreKeptByMost(const std::vector<CoupledModel>& models,
                   const CoupledCommand& command,
                   const CoupledLimits& limits,
                   double duration) {
  constexpr std::size_t kGroup = 20;  // asked at once
  const double most = kShareOfCoupled * static_cast<double>(models.size());
  const std::vector<double> stamps = WrenchLimitStamps(limits.shortest_hold, duration);
  std::atomic<int> num_breaking = 0;
  for (std::size_t first = 0; first < models.size() && num_breaking <= most; first += kGroup) {
    const std::size_t count = std::min(kGroup, models.size() - first);
    ParallelFor(static_cast<int>(count), [&](int i) {
      const auto run = WrenchMotion(models[first + static_cast<std::size_t>(i)], command, stamps);
      if (!run || !KeepsLimits(*run, limits)) ++num_breaking;
    });
  }
  return num_breaking <= most;
}

// Searches until 95 % of `others` keep the limits. False if no command does.
bool FillBlocks(const CoupledPlanRequest& request,
                const std::vector<CoupledModel>& others,
                const WrenchQuestion& question,
                CoupledPlan* plan) {
  CommandTask task = TaskOfWrench(request, question);
  const auto command_of = [&](const std::vector<WrenchBlock>& blocks) {
    return CommandOf(task.axes, blocks, task.hold);
  };
  task.judge = [&](double share) { return WrenchJudge(question, share); };
  task.is_kept_by_others = [&](const std::vector<WrenchBlock>& blocks) {
    return AreKeptByMost(others, command_of(blocks), request.limits, plan->duration);
  };
  plan->blocks = SearchCommand(task).blocks;
  if (plan->blocks.empty()) return false;
  plan->command = command_of(plan->blocks);
  return ForecastMotion(request, others, plan);
}

}  // namespace

CoupledPlan PlanCoupledExperiment(const CoupledPlanRequest& as_fitted) {
  CoupledPlanRequest request = as_fitted;
  request.model.model.time_offset = 0.0;  // of the log's clocks, not of the vehicle
  if (request.model.force_unit != "N") {
    throw InputError(fmt::format("{}: commands are in {}, expected N and N m: forces are planned.",
                                 request.name,
                                 request.model.force_unit));
  }
  CoupledPlan plan;
  plan.axes = AxesOf(request);
  TakeUsableForces(request.model.model, request.limits, &plan.axes);
  plan.thrusters = WrenchThrusters(request, plan.axes);
  SetMeasurement(request, &plan);
  const double hold = request.limits.shortest_hold;
  plan.duration = hold * std::max(1.0, std::round(request.duration / hold));

  const ToldEntries told = EntriesToTell(request, plan);
  RandomStream random(request.seed, "planning.coupled_models");
  std::vector<CoupledModel> models =
      DrawCoupledModels(request.model, kNumCoupledInSearch, request.name, random);
  models.insert(models.begin(), request.model.model);
  const std::vector<CoupledModel> others =
      DrawCoupledModels(request.model, kNumCoupledInCheck, request.name, random);

  AxisSines sines = LargestAxisSines(
      request.model.model, plan.axes, request.limits, plan.thrusters, plan.duration);
  plan.sine = std::move(sines.command);
  plan.sine_amplitude = std::move(sines.amplitude);
  WrenchQuestion question = QuestionOfWrench(request, plan, told);
  question.models = std::move(models);
  if (!FillBlocks(request, others, question, &plan)) {
    plan.message = kNoCommandKeepsLimits;
    return plan;
  }
  const auto forecast = std::span(question.models).first(kNumCoupledInForecast);
  ForecastEntries(forecast, told, question.measurement, &plan);
  if (!request.rivals.empty()) {
    ForecastSeparations(forecast, question, &plan);
  }
  for (const FreeEntry& entry : request.model.entries) {
    if (IsLeftOut(entry)) plan.left_out.push_back(NameOf(entry));
  }
  plan.message.clear();
  return plan;
}

}  // namespace fathom
