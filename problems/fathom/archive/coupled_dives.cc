// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/coupled_dives.h"

#include "fathom/archive/store/compared_dofs.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>

namespace fathom {
namespace {

constexpr std::size_t kFewestDivesThatShow = 2;

using LogsOfDofs = std::map<std::pair<std::string, std::string>, std::vector<const BatchLog*>>;

bool IsLeftOut(const BatchLog& log) {
  return std::ranges::any_of(log.dofs, [&](const BatchDof& dof) {
    return !dof.why_left_out.empty() && !AreCompared(std::string(Name(dof.dof)), log.coupled->dofs);
  });
}

// By vehicle and DOFs, of vehicles all of whose logs are done.
LogsOfDofs LogsWithCoupledModels(const std::vector<BatchLog>& logs) {
  std::set<std::string> open;
  for (const BatchLog& log : logs) {
    if (!log.is_done) open.insert(log.vehicle);
  }
  LogsOfDofs by_dofs;
  for (const BatchLog& log : logs) {
    if (open.contains(log.vehicle) || !log.coupled || IsLeftOut(log)) continue;
    by_dofs[{log.vehicle, log.coupled->dofs}].push_back(&log);
  }
  return by_dofs;
}

bool IsOfOneDive(const std::string& entry) { return IsOfRun(ParseFreeEntry(entry)); }

// What all dives of these logs free beyond a diagonal model.
std::vector<std::string> FreeInAll(const std::vector<const BatchLog*>& logs) {
  std::map<std::string, std::set<std::string>> dives_that_show;
  for (const BatchLog* log : logs) {
    for (const std::string& entry : log->coupled->beyond_diagonal) {
      if (!IsOfOneDive(entry)) dives_that_show[entry].insert(log->dive);
    }
  }
  std::vector<std::string> free;
  for (const auto& [entry, dives] : dives_that_show) {
    if (dives.size() >= kFewestDivesThatShow) free.push_back(entry);
  }
  return free;
}

}  // namespace

std::map<CoupledFitKey, CoupledDiveTask> CoupledDiveTasks(
    const std::vector<BatchLog>& logs, const std::map<std::string, int>& place_of_dive) {
  std::map<CoupledFitKey, CoupledDiveTask> tasks;
  for (const auto& [key, of_dofs] : LogsWithCoupledModels(logs)) {
    std::set<std::string> dives;
    for (const BatchLog* log : of_dofs) dives.insert(log->dive);
    if (dives.size() < kFewestDivesForChange) continue;
    const auto num_coriolis =
        std::ranges::count_if(of_dofs, [](const BatchLog* log) { return log->coupled->coriolis; });
    const std::vector<std::string> free = FreeInAll(of_dofs);
    for (const BatchLog* log : of_dofs) {
      CoupledDiveTask& task = tasks[{key.first, key.second, place_of_dive.at(log->dive)}];
      task.vehicle = log->vehicle;
      task.dive = log->dive;
      task.dofs = key.second;
      task.coriolis = 2 * num_coriolis > std::ssize(of_dofs);
      if (task.logs.empty()) task.free = free;
      task.logs.push_back(log->log);
      // A current is that of its own log.
      std::ranges::copy_if(
          log->coupled->beyond_diagonal, std::back_inserter(task.free), IsOfOneDive);
    }
  }
  return tasks;
}

}  // namespace fathom
