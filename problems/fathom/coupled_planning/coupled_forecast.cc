// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_forecast.h"

#include "fathom/base/parallel_for.h"
#include "fathom/base/quantile.h"
#include "fathom/coupled_planning/kept_wrench.h"
#include "fathom/planning/information.h"
#include "fathom/simulate/coupled/attitude_angles.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

namespace fathom {
namespace {

using CoupledRuns = std::vector<std::vector<CoupledState>>;

// Of what is known so far this much is counted along, so that what a run leaves open has a number.
constexpr double kTraceOfSoFar = 1e-8;
constexpr double kOpen = 1000.0;  // times as wide as before: the run alone leaves it open

Eigen::VectorXd StdsOf(const Eigen::MatrixXd& information) {
  return InverseOf(information).diagonal().cwiseSqrt();
}

// Without the model's own log.
Eigen::VectorXd StdsAlone(const Eigen::MatrixXd& information,
                          const Eigen::MatrixXd& so_far,
                          const Eigen::VectorXd& before) {
  Eigen::VectorXd stds = StdsOf(information + kTraceOfSoFar * so_far);
  for (Eigen::Index i = 0; i < stds.size(); ++i) {
    if (stds[i] > kOpen * before[i]) stds[i] = std::numeric_limits<double>::infinity();
  }
  return stds;
}

template <typename Numbers, typename Place>
double MedianAt(const std::vector<Numbers>& of_models, Place at) {
  std::vector<double> values;
  for (const Numbers& of_model : of_models) values.push_back(of_model[at]);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Between the quantiles of 2.5 and 97.5 % at each stamp of what a state shows.
PlannedBand BandOfStates(const std::vector<CoupledState>& nominal,
                         const CoupledRuns& runs,
                         const std::function<double(const CoupledState&)>& shown) {
  PlannedBand band;
  std::vector<double> values(runs.size());
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    for (std::size_t run = 0; run < runs.size(); ++run) values[run] = shown(runs[run][i]);
    band.value.push_back(shown(nominal[i]));
    band.low.push_back(Quantile(values, 0.025));
    band.high.push_back(Quantile(values, 0.975));
  }
  return band;
}

double GreatestTilt(const std::vector<CoupledState>& run) {
  double greatest = 0.0;
  for (const CoupledState& state : run) greatest = std::max(greatest, TiltOf(state));
  return greatest;
}

}  // namespace

void ForecastEntries(std::span<const CoupledModel> models,
                     const ToldEntries& told,
                     const WrenchMeasurement& measurement,
                     CoupledPlan* plan) {
  const Eigen::MatrixXd so_far = InverseOf(told.covariance);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(so_far.rows(), so_far.cols());
  // Without logs, the model's own to the bit.
  const bool has_flown = told.flown.norm() > 0.0;
  const Eigen::VectorXd before =
      has_flown ? StdsOf(so_far + told.flown) : told.covariance.diagonal().cwiseSqrt().eval();
  std::vector<Eigen::VectorXd> after(models.size()), both(after), sine(after);
  ParallelFor(static_cast<int>(models.size()), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    WrenchInformation information(models[at], told.entries, measurement);
    const auto with_flown = [&](const CoupledCommand& command) -> Eigen::MatrixXd {
      return told.flown + information.Of(command, plan->duration).value_or(none);
    };
    const Eigen::MatrixXd of_plan = with_flown(plan->command);
    after[at] = StdsAlone(of_plan, so_far, before);
    both[at] = StdsOf(of_plan + so_far);
    sine[at] = StdsAlone(with_flown(plan->sine), so_far, before);
  });
  for (std::size_t k = 0; k < told.entries.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    plan->parameters.push_back({NameOf(told.entries[k]),
                                UnitOf(told.entries[k]),
                                ValueIn(models.front(), told.entries[k]),
                                before[at],
                                MedianAt(after, at),
                                MedianAt(both, at),
                                MedianAt(sine, at)});
  }
}

void ForecastSeparations(std::span<const CoupledModel> models,
                         const WrenchQuestion& question,
                         CoupledPlan* plan) {
  const auto size = static_cast<Eigen::Index>(question.entries.size());
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(size, size);
  std::vector<std::vector<double>> of_plan(models.size()), of_sine(of_plan);
  ParallelFor(static_cast<int>(models.size()), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    WrenchInformation information(models[at], question.entries, question.measurement);
    const auto sigmas_under = [&](const CoupledCommand& command) {
      return SigmasOf(question.rivals,
                      question.so_far.rows(),
                      information.Of(command, plan->duration).value_or(none));
    };
    of_plan[at] = sigmas_under(plan->command);
    of_sine[at] = sigmas_under(plan->sine);
  });
  const auto name_at = [&](Eigen::Index row) {
    return NameOf(question.entries[static_cast<std::size_t>(row)]);
  };
  for (std::size_t k = 0; k < question.rivals.size(); ++k) {
    plan->separations.push_back({.truth = name_at(question.rivals[k].truth),
                                 .assumed = name_at(question.rivals[k].assumed),
                                 .sigmas = MedianAt(of_plan, k),
                                 .sine = MedianAt(of_sine, k)});
  }
}

bool ForecastMotion(const CoupledPlanRequest& request,
                    std::span<const CoupledModel> others,
                    CoupledPlan* plan) {
  plan->time = WrenchLimitStamps(request.limits.shortest_hold, plan->duration);
  const auto nominal = WrenchMotion(request.model.model, plan->command, plan->time);
  if (!nominal) return false;
  std::vector<std::optional<std::vector<CoupledState>>> motions(others.size());
  ParallelFor(static_cast<int>(others.size()), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    motions[at] = WrenchMotion(others[at], plan->command, plan->time);
  });
  CoupledRuns runs;
  std::vector<double> tilts;
  int num_breaking = 0;
  for (const auto& motion : motions) {
    if (!motion || !KeepsLimits(*motion, request.limits)) ++num_breaking;
    if (!motion) continue;
    runs.push_back(*motion);
    tilts.push_back(GreatestTilt(*motion));
  }
  plan->num_models = static_cast<int>(others.size());
  plan->share_breaking = static_cast<double>(num_breaking) / plan->num_models;
  if (runs.empty()) return false;
  for (const Dof dof : request.model.model.dofs) {
    plan->speed[static_cast<std::size_t>(Index(dof))] = BandOfStates(
        *nominal, runs, [&](const CoupledState& state) { return state.nu[Index(dof)]; });
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    plan->position[axis] = BandOfStates(*nominal, runs, [&](const CoupledState& state) {
      return state.position[static_cast<Eigen::Index>(axis)];
    });
  }
  plan->tilt = Quantile(tilts, 0.95);
  // Without a limit the bow may go round and round.
  if (std::isfinite(request.limits.heading)) {
    plan->heading = BandOfStates(
        *nominal, runs, [](const CoupledState& state) { return UnwrappedHeading(state, 0.0); });
  }
  return true;
}

}  // namespace fathom
