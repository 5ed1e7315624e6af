// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_caveats.h"

#include "fathom/base/interval95.h"
#include "fathom/simulate/noise_floor.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

using Caveats = std::vector<std::string>;

void AddUnitOfForces(const IdentificationTask& task, Caveats* caveats) {
  if (!task.unit_fin) return;
  caveats->push_back(
      fmt::format("Nothing of a known force drives {}: forces are in units of fin_force.{}, which "
                  "is taken as 1. Ratios hold, as Nomoto's K and T (fathom_simulate --table). "
                  "`area` and `lift_slope` in the vehicle file, or a wrench in N, give kilograms.",
                  Name(task.dofs.front()),
                  *task.unit_fin));
}

void AddFinsTurnedRound(const CoupledSummary& fit, Caveats* caveats) {
  for (const FreeEntry& entry : fit.entries) {
    if (entry.kind != FreeEntry::Kind::kFinForce) continue;
    if (ValueIn(fit.model, entry) + kStdsOf95 * StdOf(fit, entry) >= 0.0) continue;
    caveats->push_back(
        fmt::format("{} is below 0: in this log the fin turns the vehicle the other way than its "
                    "vehicle file says. Turn its `axis` round, or the sign of its angles.",
                    NameOf(entry)));
  }
}

void AddShaftsWithoutCurve(const IdentificationTask& task, Caveats* caveats) {
  for (const CommandedShaft& shaft : task.logs.data.front().inputs.command.shafts) {
    if (shaft.shaft.curve) continue;
    caveats->push_back(fmt::format(
        "The vehicle file tells no `thrust` of the shaft '{0}': thrust_gain.{0} takes it for the "
        "same at every speed, which it is not, and other numbers make up for that. "
        "`thrust: {{linear: [K_0, K_1]}}`, K_T over J, mends it.",
        shaft.shaft.name));
  }
}

void AddPriors(const CoupledSummary& fit, const std::string& force_unit, Caveats* caveats) {
  for (const EntryPrior& prior : fit.priors) {
    caveats->push_back(fmt::format(
        "These data do not tell {0}. It is taken to be near {1:.3g} {2}, the inertia of the other "
        "axes, within a factor of four; the other numbers of {3} grow with it. Drive {3} to know "
        "it.",
        NameOf(prior.entry),
        prior.centre,
        UnitOf(prior.entry, force_unit),
        Name(prior.entry.row)));
  }
}

void AddBounds(const CoupledSummary& fit, Caveats* caveats) {
  if (fit.on_bound.empty()) return;
  std::vector<std::string> names;
  for (const FreeEntry& entry : fit.on_bound) names.push_back(NameOf(entry));
  caveats->push_back(
      fmt::format("The best fit lies where a body ends, at a damping of 0 or at the body's own "
                  "inertia, for {}. Cut the intervals there.",
                  fmt::join(names, ", ")));
}

// Dampings of one axis that may as well be 0, or twice as large.
void AddOpenDampings(const CoupledSummary& fit, Caveats* caveats) {
  std::vector<std::string> open;
  for (const FreeEntry& entry : fit.entries) {
    const bool is_damping = entry.kind == FreeEntry::Kind::kLinearDamping ||
                            entry.kind == FreeEntry::Kind::kQuadraticDamping;
    if (!is_damping || entry.row != entry.column) continue;
    if (std::ranges::count(fit.on_bound, entry) > 0) continue;
    if (kStdsOf95 * StdOf(fit, entry) > std::abs(ValueIn(fit.model, entry))) {
      open.push_back(NameOf(entry));
    }
  }
  if (open.empty()) return;
  caveats->push_back(
      fmt::format("These logs do not determine {}: 95 % intervals are wider than ± 100 % of the "
                  "value. Steady runs at several speeds determine a damping; fathom_plan designs "
                  "them.",
                  fmt::join(open, ", ")));
}

// The DOFs of which free runs miss much, and far more than scatters from sample to sample.
void AddPoorFit(const FittedCoupledModel& fitted,
                std::span<const CoupledData> logs,
                const CoupledPrediction& prediction,
                Caveats* caveats) {
  std::vector<std::string> poor;
  for (const Dof dof : fitted.model.dofs) {
    const double nmae = fitted.train[static_cast<std::size_t>(Index(dof))].nmae;
    const double scatter = NmaeOfScatter(FreeRunsAlong(dof, logs, prediction));
    if (!(nmae > kPoorFit) || nmae < kMuchMoreThanScatter * scatter) continue;
    poor.push_back(fmt::format("{:.0f} % of {}", 100.0 * nmae, Name(dof)));
  }
  if (poor.empty()) return;
  caveats->push_back(fmt::format(
      "The fit is poor: simulated from the command alone, it misses {}. Check the warnings first. "
      "Then run fathom_diagnose --dofs on these logs: it looks for what the model lacks.",
      fmt::join(poor, ", ")));
}

}  // namespace

std::vector<std::string> CaveatsOnModel(const FittedCoupledModel& fitted,
                                        const CoupledSummary& fit,
                                        const IdentificationTask& task) {
  Caveats caveats;
  AddUnitOfForces(task, &caveats);
  AddFinsTurnedRound(fit, &caveats);
  AddShaftsWithoutCurve(task, &caveats);
  AddPriors(fit, fitted.force_unit, &caveats);
  return caveats;
}

std::vector<std::string> CaveatsOnFit(const FittedCoupledModel& fitted,
                                      const CoupledSummary& fit,
                                      std::span<const CoupledData> logs,
                                      const CoupledPrediction& prediction) {
  Caveats caveats;
  AddBounds(fit, &caveats);
  AddOpenDampings(fit, &caveats);
  AddPoorFit(fitted, logs, prediction, &caveats);
  return caveats;
}

}  // namespace fathom
