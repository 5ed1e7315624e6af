// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/plan_coupled.h"

#include "fathom/base/input_error.h"
#include "fathom/coupled_planning/axis_sines.h"
#include "fathom/coupled_planning/coupled_forecast.h"
#include "fathom/coupled_planning/coupled_noise.h"
#include "fathom/coupled_planning/drawn_coupled_models.h"
#include "fathom/coupled_planning/flown_entries.h"
#include "fathom/coupled_planning/kept_wrench.h"
#include "fathom/coupled_planning/wrench_run.h"
#include "fathom/coupled_planning/wrench_search.h"
#include "fathom/coupled_planning/wrench_thrusters.h"
#include "fathom/planning/information.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>
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
constexpr int kNumCoupledTrials = 3;      // with limits narrower from one to the next
constexpr double kNarrowerForNext = 0.9;
constexpr int kFewerMovesForNext = 4;  // so that planning takes seconds still
constexpr double kWeightSoFar = 0.03;  // w of docs/plan.md (2)

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
void AddRivals(const CoupledPlanRequest& request, const CoupledPlan& plan, WrenchTask* task) {
  if (request.rivals.empty()) return;
  task->rivals = PlaceRivals(request.rivals, &task->entries);
  WrenchInformation information(request.model.model, task->entries, task->measurement);
  const auto of_sines = information.Of(plan.sine, plan.duration);
  if (of_sines) task->rivals = BothWays(task->rivals, task->so_far.rows(), *of_sines);
}

WrenchTask TaskOfWrench(const CoupledPlanRequest& request,
                        const CoupledPlan& plan,
                        const ToldEntries& told) {
  WrenchTask task;
  task.axes = plan.axes;
  task.thrusters = plan.thrusters;
  task.limits = request.limits;
  task.duration = plan.duration;
  task.seed = request.seed;
  task.entries = told.entries;
  task.so_far = kWeightSoFar * InverseOf(told.covariance) + told.flown;
  task.measurement = MeasurementFor(request, plan);
  AddRivals(request, plan, &task);
  const auto num_columns =
      static_cast<double>(NumCoupledColumns(request.model.model, task.entries));
  const double moves = std::min(kMostCoupledMoves, kCoupledWork / (plan.duration * num_columns));
  task.num_moves = std::max(10, static_cast<int>(request.effort * moves));
  return task;
}

// Halves the force of an axis until one hold of it, and the coast behind, keeps the limits: what is
// more is of no use.
void TakeUsableForces(const CoupledModel& model,
                      const CoupledLimits& limits,
                      std::vector<WrenchAxis>* axes) {
  constexpr int kMostHalvings = 40;
  const std::vector<double> stamps = LimitStamps(limits.shortest_hold);
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

CoupledLimits Narrowed(CoupledLimits limits) {
  for (double& speed : limits.speed) speed *= kNarrowerForNext;
  for (ValueRange& range : limits.room) {
    range = {kNarrowerForNext * range.low, kNarrowerForNext * range.high};
  }
  limits.tilt *= kNarrowerForNext;
  limits.heading *= kNarrowerForNext;
  return limits;
}

// The last of the commands that a search came by under which 95 % of `others` keep the limits,
// gone back by one, two, four ... False if none does.
bool FillBlocksFrom(FoundWrench found,
                    const CoupledPlanRequest& request,
                    const std::vector<CoupledModel>& others,
                    CoupledPlan* plan) {
  found.before.push_back(std::move(found.blocks));
  const auto last = static_cast<std::ptrdiff_t>(found.before.size()) - 1;
  for (std::ptrdiff_t back = 0; back <= last; back = 2 * back + 1) {
    plan->blocks = found.before[static_cast<std::size_t>(last - back)];
    plan->command = CommandOf(plan->axes, plan->blocks, request.limits.shortest_hold);
    if (!ForecastMotion(request, others, plan)) return false;
    if (plan->share_breaking <= kShareOfCoupled) return true;
  }
  return false;
}

// Searches until 95 % of `others` keep the limits. False if no command does.
bool FillBlocks(const CoupledPlanRequest& request,
                const std::vector<CoupledModel>& others,
                WrenchTask task,
                CoupledPlan* plan) {
  for (int trial = 0; trial < kNumCoupledTrials; ++trial) {
    FoundWrench found = SearchWrench(task);
    if (found.blocks.empty()) return false;
    if (FillBlocksFrom(std::move(found), request, others, plan)) return true;
    task.limits = Narrowed(task.limits);
    task.num_moves /= kFewerMovesForNext;
  }
  return false;
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
  WrenchTask task = TaskOfWrench(request, plan, told);
  task.models = std::move(models);
  if (!FillBlocks(request, others, task, &plan)) {
    plan.message = kNoCommandKeepsLimits;
    return plan;
  }
  const auto forecast = std::span(task.models).first(kNumCoupledInForecast);
  ForecastEntries(forecast, told, task.measurement, &plan);
  if (!request.rivals.empty()) {
    ForecastSeparations(forecast, task, &plan);
  }
  for (const FreeEntry& entry : request.model.entries) {
    if (IsLeftOut(entry)) plan.left_out.push_back(NameOf(entry));
  }
  plan.message.clear();
  return plan;
}

}  // namespace fathom
