// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/identification_task.h"

#include "fathom/base/input_error.h"
#include "fathom/base/listed.h"
#include "fathom/log/distinct_names.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// As a fit takes them.
CoupledLogs CoupledLogsOf(std::vector<Log> logs,
                          const std::vector<Dof>& dofs,
                          const std::optional<Vehicle>& vehicle) {
  CoupledLogs out;
  // Currents and offsets of runs are told apart by the names of logs.
  const std::vector<std::string> names = DistinctNames(logs);
  for (std::size_t k = 0; k < logs.size(); ++k) logs[k].name = names[k];
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

// Each window begins with velocities of its own, on which its first samples go.
void RequireLongWindows(const CoupledLogs& logs, double window) {
  constexpr int kFewestSamples = 5;
  for (const CoupledData& data : logs.data) {
    for (const CoupledSegment& segment : data.segments) {
      const std::size_t count = segment.time.size();
      if (count < 2) continue;
      const double period =
          (segment.time.back() - segment.time.front()) / static_cast<double>(count - 1);
      if (window > (kFewestSamples - 0.5) * period) continue;
      throw InputError(fmt::format(
          "--window: {:g} s holds fewer than {} samples of {}, expected at least {:.2g} s.",
          window,
          kFewestSamples,
          data.log,
          kFewestSamples * period));
    }
  }
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

// What is not free of the inertia is the body's own, where that is known.
void HoldRigidInertia(const std::vector<Dof>& dofs, CoupledFitOptions* fit) {
  const auto rigid = RigidInertia(fit->body);
  if (!rigid) return;
  for (const Dof row : dofs) {
    for (const Dof column : dofs) {
      fit->held.inertia(Index(row), Index(column)) = (*rigid)(Index(row), Index(column));
    }
  }
}

}  // namespace

IdentificationTask IdentificationTaskOf(std::vector<Log> logs,
                                        const std::vector<Dof>& dofs,
                                        const CoupledFitOptions& fit) {
  const std::optional<Vehicle> vehicle = FirstVehicleOf(logs);
  IdentificationTask task;
  task.logs = CoupledLogsOf(std::move(logs), dofs, vehicle);
  RequireLongWindows(task.logs, fit.window);
  task.dofs = dofs;
  task.fit = fit;
  if (vehicle) task.fit.body = vehicle->body;
  HoldRigidInertia(dofs, &task.fit);
  for (const CommandedFin& fin : task.logs.data.front().inputs.command.fins) {
    if (fin.force) task.fit.held.fin_force[fin.name] = *fin.force;
  }
  task.unit_fin = UnitFin(task.logs, dofs);
  if (task.unit_fin) {
    task.fit.held.fin_force[*task.unit_fin] = 1.0;
    task.fit.body = {};  // in kg, which these forces are not
  }
  return task;
}

MotionStructure StructureIn(const IdentificationTask& task,
                            StandardStructure standard,
                            const std::vector<FreeEntry>& also_free) {
  return WithEntries(
      StructureOf(standard, task.dofs, FinsOf(task.logs, task.fit.held), FreeGains(task.logs)),
      also_free,
      task.logs);
}

EntrySearchOptions SearchIn(const IdentificationTask& task) {
  const CoupledCommand& command = task.logs.data.front().inputs.command;
  EntrySearchOptions search;
  search.fit = task.fit;
  for (const CommandedThruster& thruster : command.thrusters) {
    search.thrusters.push_back(thruster.name);
  }
  for (const CommandedShaft& shaft : command.shafts) {
    if (shaft.shaft.IsThrustKnown()) search.thrusters.push_back(shaft.shaft.name);
  }
  search.gains = FreeGains(task.logs);
  search.fins = FinsOf(task.logs, task.fit.held);
  return search;
}

std::string WhyStill(const IdentificationTask& task) {
  std::vector<std::string> still, moving;
  for (const Dof dof : task.dofs) {
    (IsStill(task.logs, dof) ? still : moving).emplace_back(Name(dof));
  }
  if (still.empty()) return "";
  const std::string rest =
      moving.empty() ? "" : fmt::format("; try --dofs={}", fmt::join(moving, ","));
  return fmt::format("the speed along {} never changes in these logs{}", Listed(still), rest);
}

}  // namespace fathom
