// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_identification.h"

#include "fathom/base/input_error.h"
#include "fathom/base/listed.h"
#include "fathom/coupled/entry_search.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/simulate/noise_floor.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::optional<Vehicle> VehicleOfAll(const std::vector<Log>& logs) {
  for (const Log& log : logs) {
    if (auto vehicle = VehicleOf(log)) return vehicle;
  }
  return std::nullopt;
}

std::string NamesOfEntries(const std::vector<FreeEntry>& entries) {
  std::vector<std::string> names;
  for (const FreeEntry& entry : entries) names.push_back(NameOf(entry));
  return fmt::format("{}", fmt::join(names, ", "));
}

// As a fit takes them.
CoupledLogs CoupledLogsOf(std::vector<Log> logs,
                          const std::vector<Dof>& dofs,
                          const std::optional<Vehicle>& vehicle) {
  CoupledLogs out;
  for (const Log& log : logs) {
    const Vehicle of_log = vehicle.value_or(Vehicle());
    out.data.push_back(CoupledDataOf(log, dofs, of_log.thrusters, of_log.fins, of_log.shafts));
    if (out.data.back().force_unit != out.data.front().force_unit) {
      throw InputError(fmt::format("{}: is commanded in {}, expected {} as in {}.",
                                   log.path.string(),
                                   out.data.back().force_unit,
                                   out.data.front().force_unit,
                                   logs.front().path.string()));
    }
  }
  out.logs = std::move(logs);
  return out;
}

// `held`: the numbers that are not free.
std::vector<StructureFin> FinsOf(const CoupledLogs& logs, const CoupledModel& held) {
  std::vector<StructureFin> fins;
  for (const CommandedFin& fin : logs.data.front().inputs.command.fins) {
    fins.push_back({fin.name, held.fin_force.contains(fin.name), !fin.behind.empty()});
  }
  return fins;
}

// The shafts whose thrust the vehicle file does not tell.
std::vector<std::string> FreeGains(const CoupledLogs& logs) {
  std::vector<std::string> gains;
  for (const CommandedShaft& shaft : logs.data.front().inputs.command.shafts) {
    if (!shaft.shaft.IsThrustKnown()) gains.push_back(shaft.shaft.name);
  }
  return gains;
}

// Whether the logs, with these DOFs, have what the entry is of.
bool IsIn(const FreeEntry& entry, const CoupledLogs& logs, const std::vector<Dof>& dofs) {
  const CoupledCommand& command = logs.data.front().inputs.command;
  if (!IsOfActuator(entry)) {
    const Dof row = entry.kind == FreeEntry::Kind::kNetBuoyancy ? Dof::kHeave : entry.row;
    const bool has_column =
        entry.kind == FreeEntry::Kind::kNetBuoyancy || std::ranges::count(dofs, entry.column) > 0;
    return has_column && std::ranges::count(dofs, row) > 0;
  }
  if (entry.actuator.empty()) return true;  // of all
  if (IsOfRun(entry)) {
    return std::ranges::count(dofs, entry.row) > 0 &&
           std::ranges::count(logs.data, entry.actuator, &CoupledData::log) == 1;
  }
  if (entry.kind != FreeEntry::Kind::kThrustGain) {
    return std::ranges::any_of(command.fins,
                               [&](const auto& fin) { return fin.name == entry.actuator; });
  }
  return std::ranges::any_of(
             command.thrusters,
             [&](const auto& thruster) { return thruster.name == entry.actuator; }) ||
         std::ranges::any_of(command.shafts, [&](const CommandedShaft& shaft) {
           return shaft.shaft.name == entry.actuator;
         });
}

// The structure with these entries too.
MotionStructure WithEntries(MotionStructure structure,
                            const std::vector<FreeEntry>& entries,
                            const CoupledLogs& logs) {
  for (const FreeEntry& entry : entries) {
    if (!IsIn(entry, logs, structure.dofs)) {
      throw InputError(
          fmt::format("{}: nothing is there for {} to be of, expected a thruster or a fin of the "
                      "vehicle file, the name in one log.yaml, or DOFs that are modelled.",
                      logs.data.front().log,
                      NameOf(entry)));
    }
    if (std::ranges::count(structure.entries, entry) == 0) structure.entries.push_back(entry);
  }
  for (const FreeEntry& entry : structure.entries) {
    if (entry.kind != FreeEntry::Kind::kFinRateLimit) continue;
    if (std::ranges::count(structure.entries, FinLagEntry(entry.actuator)) == 0) continue;
    throw InputError(fmt::format("--free: holds both {} and {}, expected one of them.",
                                 NameOf(FinLagEntry(entry.actuator)),
                                 NameOf(entry)));
  }
  return structure;
}

// Whether something of a known force drives a DOF.
bool IsDrivenInNewtons(const CoupledData& log, Dof dof) {
  const CoupledCommand& command = log.inputs.command;
  const auto row = Index(dof);
  return std::ranges::any_of(command.force, [&](const Vector6& f) { return f[row] != 0.0; }) ||
         std::ranges::any_of(command.thrusters,
                             [&](const auto& thruster) { return thruster.push[row] != 0.0; }) ||
         std::ranges::any_of(command.shafts,
                             [&](const auto& shaft) {
                               return shaft.push[row] != 0.0 && shaft.shaft.IsThrustKnown();
                             }) ||
         std::ranges::any_of(command.fins, [&](const CommandedFin& fin) {
           return fin.force && fin.arms.across[row] != 0.0;
         });
}

// The fin whose force is the unit of all others: of one DOF that fins of unknown forces alone
// drive. Nothing where newtons are known.
std::optional<std::string> UnitFin(const CoupledLogs& logs, const std::vector<Dof>& dofs) {
  if (dofs.size() != 1) return std::nullopt;
  const auto is_driven = [&](const CoupledData& log) {
    return IsDrivenInNewtons(log, dofs.front());
  };
  if (std::ranges::any_of(logs.data, is_driven)) return std::nullopt;
  for (const CommandedFin& fin : logs.data.front().inputs.command.fins) {
    if (fin.arms.across[Index(dofs.front())] != 0.0) return fin.name;
  }
  return std::nullopt;
}

// Whether the speed along a DOF is known and never changes.
bool IsStill(const CoupledLogs& logs, Dof dof) {
  std::optional<double> first;
  for (const CoupledData& data : logs.data) {
    for (const CoupledSegment& segment : data.segments) {
      for (const Vector6& velocity : segment.velocity) {
        const double speed = velocity[Index(dof)];
        if (speed != first.value_or(speed)) return false;
        first = speed;
      }
    }
  }
  return first.has_value();
}

// Why no model of these DOFs can be told, where the speed along some never changes; else empty.
std::string WhyStill(const CoupledLogs& logs, const std::vector<Dof>& dofs) {
  std::vector<std::string> still, moving;
  for (const Dof dof : dofs) (IsStill(logs, dof) ? still : moving).emplace_back(Name(dof));
  if (still.empty()) return "";
  const std::string rest =
      moving.empty() ? "" : fmt::format("; try --dofs={}", fmt::join(moving, ","));
  return fmt::format("the speed along {} never changes in these logs{}", Listed(still), rest);
}

// A caveat on the DOFs of which free runs miss much, and far more than scatters from sample to
// sample; empty where there is none.
std::string CaveatOnPoorFit(const CoupledIdentification& identified) {
  std::vector<std::string> poor;
  for (const Dof dof : identified.fitted.model.dofs) {
    const double nmae = identified.fitted.train[static_cast<std::size_t>(Index(dof))].nmae;
    const double scatter = NmaeOfScatter(RunsAlong(dof, identified));
    if (!(nmae > kPoorFit) || nmae < kMuchMoreThanScatter * scatter) continue;
    poor.push_back(fmt::format("{:.0f} % of {}", 100.0 * nmae, Name(dof)));
  }
  if (poor.empty()) return "";
  return fmt::format(
      "The fit is poor: simulated from the command alone, it misses {}. Check the warnings first. "
      "Then run fathom_diagnose --dofs on these logs: it looks for what the model lacks.",
      fmt::join(poor, ", "));
}

}  // namespace

CoupledIdentification IdentifyCoupled(std::vector<Log> logs,
                                      const CoupledIdentificationOptions& options) {
  if (logs.empty()) throw InputError("An identification needs at least one log.");
  const std::optional<Vehicle> vehicle = VehicleOfAll(logs);
  CoupledIdentification identified;
  identified.fitted.log_fingerprints = FingerprintsOf(logs);
  CoupledLogs all = CoupledLogsOf(std::move(logs), options.dofs, vehicle);
  for (const CoupledData& data : all.data) {
    for (const std::string& remark : data.remarks) {
      identified.remarks.push_back(all.data.size() > 1 ? fmt::format("{}: {}", data.log, remark)
                                                       : remark);
    }
  }
  identified.message = WhyStill(all, options.dofs);
  if (!identified.message.empty()) return identified;
  CoupledFitOptions fit = options.fit;
  if (vehicle) fit.body = vehicle->body;
  // What is not free of the inertia is the body's own, where that is known.
  if (const auto rigid = RigidInertia(fit.body)) {
    for (const Dof row : options.dofs) {
      for (const Dof column : options.dofs) {
        fit.held.inertia(Index(row), Index(column)) = (*rigid)(Index(row), Index(column));
      }
    }
  }
  for (const CommandedFin& fin : all.data.front().inputs.command.fins) {
    if (fin.force) fit.held.fin_force[fin.name] = *fin.force;
  }
  const auto unit_fin = UnitFin(all, options.dofs);
  if (unit_fin) {
    fit.held.fin_force[*unit_fin] = 1.0;
    fit.body = {};  // in kg, which these forces are not
  }
  if (options.structure) {
    identified.structure = WithEntries(
        StructureOf(*options.structure, options.dofs, FinsOf(all, fit.held), FreeGains(all)),
        options.also_free,
        all);
    identified.fit = FitBlocks(all, identified.structure, fit);
    identified.fitted.structure = std::string(Name(*options.structure));
  } else {
    EntrySearchOptions search;
    search.fit = fit;
    const auto& thrusters = all.data.front().inputs.command.thrusters;
    for (const CommandedThruster& thruster : thrusters) search.thrusters.push_back(thruster.name);
    search.gains = FreeGains(all);
    for (const CommandedShaft& shaft : all.data.front().inputs.command.shafts) {
      if (shaft.shaft.IsThrustKnown()) search.thrusters.push_back(shaft.shaft.name);
    }
    search.fins = FinsOf(all, fit.held);
    identified.ladder = ClimbLadder(all, options.dofs, search);
    const LadderRung& accepted = identified.ladder->rungs[identified.ladder->accepted];
    identified.structure = accepted.structure;
    identified.fit = accepted.fit;
    identified.fitted.structure = "auto";
  }
  identified.fit_options = fit;
  identified.data = std::move(all.data);
  const CoupledSummary& result = identified.fit;
  identified.message = result.message;
  identified.is_usable = result.IsUsable();
  if (!identified.is_usable) return identified;
  FittedCoupledModel& fitted = identified.fitted;
  fitted.model = result.model;
  fitted.model.dofs = options.dofs;
  fitted.entries = result.entries;
  fitted.covariance = result.covariance;
  fitted.force_unit = unit_fin.value_or(identified.data.front().force_unit);
  fitted.horizon = fit.window;
  fitted.residual_autoregression = result.colour_of_uncoupled;
  for (const ChannelNoise& noise : result.noise) {
    if (noise.channel.kind != FittedChannel::Kind::kVelocity) continue;
    const auto row = static_cast<std::size_t>(noise.channel.row);
    fitted.residual_autoregression[row] = noise.whitener.coefficients();
  }
  if (unit_fin) {
    fitted.caveats.push_back(fmt::format(
        "Nothing of a known force drives {}: forces are in units of fin_force.{}, which "
        "is taken as 1. Ratios hold, as Nomoto's K and T (fathom_simulate --table). "
        "`area` and `lift_slope` in the vehicle file, or a wrench in N, give kilograms.",
        Name(options.dofs.front()),
        *unit_fin));
  }
  for (const FreeEntry& entry : fitted.entries) {
    if (entry.kind != FreeEntry::Kind::kFinForce) continue;
    if (ValueIn(fitted.model, entry) + 1.96 * StdOf(result, entry) >= 0.0) continue;
    fitted.caveats.push_back(
        fmt::format("{} is below 0: in this log the fin turns the vehicle the other way than its "
                    "vehicle file says. Turn its `axis` round, or the sign of its angles.",
                    NameOf(entry)));
  }
  for (const CommandedShaft& shaft : identified.data.front().inputs.command.shafts) {
    if (shaft.shaft.curve) continue;
    fitted.caveats.push_back(fmt::format(
        "The vehicle file tells no `thrust` of the shaft '{0}': thrust_gain.{0} takes it for the "
        "same at every speed, which it is not, and other numbers make up for that. "
        "`thrust: {{linear: [K_0, K_1]}}`, K_T over J, mends it.",
        shaft.shaft.name));
  }
  for (const EntryPrior& prior : result.priors) {
    fitted.caveats.push_back(fmt::format(
        "These data do not tell {0}. It is taken to be near {1:.3g} {2}, the inertia of the other "
        "axes, within a factor of four; the other numbers of {3} grow with it. Drive {3} to know "
        "it.",
        NameOf(prior.entry),
        prior.centre,
        UnitOf(prior.entry, fitted.force_unit),
        Name(prior.entry.row)));
  }
  if (!result.on_bound.empty()) {
    identified.caveats_on_fit.push_back(
        fmt::format("Ended on what a body can be, no damping below 0 and no inertia below the "
                    "body's own: {}. These intervals are to be cut there.",
                    NamesOfEntries(result.on_bound)));
  }
  auto prediction = PredictCoupled(fitted.model, identified.data, fit.window);
  if (!prediction) {
    identified.is_usable = false;
    identified.message = "free runs of the model diverge";
    return identified;
  }
  fitted.train = prediction->train;
  fitted.held_out = prediction->held_out;
  identified.prediction = std::move(*prediction);
  if (auto caveat = CaveatOnPoorFit(identified); !caveat.empty()) {
    identified.caveats_on_fit.push_back(std::move(caveat));
  }
  fitted.caveats.insert(
      fitted.caveats.end(), identified.caveats_on_fit.begin(), identified.caveats_on_fit.end());
  if (identified.ladder && identified.ladder->rungs.front().fit.converged) {
    CoupledModel diagonal = identified.ladder->rungs.front().fit.model;
    diagonal.dofs = options.dofs;
    identified.diagonal = PredictCoupled(diagonal, identified.data, fit.window);
  }
  return identified;
}

std::vector<FreeRun> RunsAlong(Dof dof, const CoupledIdentification& identified) {
  std::vector<FreeRun> runs;
  for (std::size_t k = 0; k < identified.data.size(); ++k) {
    for (std::size_t s = 0; s < identified.data[k].segments.size(); ++s) {
      const CoupledSegment& segment = identified.data[k].segments[s];
      runs.push_back(FreeRunAlong(
          dof, segment, {0, segment.time.size()}, identified.prediction.velocity[k][s]));
    }
  }
  return runs;
}

}  // namespace fathom
