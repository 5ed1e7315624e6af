// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dive_batch.h"

#include "fathom/archive/changes_of_dives.h"
#include "fathom/archive/dives/dive_order.h"
#include "fathom/archive/jobs/run_in_parallel.h"
#include "fathom/archive/jobs/unfinished_runs.h"
#include "fathom/archive/store/rows_of_log.h"
#include "fathom/base/utc_time.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

namespace fathom {
namespace {

// The earlier of two starts, of which either may not be known.
void TakeEarlier(double start, double* earliest) {
  if (!(*earliest <= start)) *earliest = std::isfinite(start) ? start : *earliest;
}

std::vector<std::string> InOrder(const std::map<std::string, double>& starts) {
  std::vector<DiveStart> dives;
  for (const auto& [name, start] : starts) dives.push_back({name, start});
  return InOrder(std::move(dives));
}

std::vector<std::string> DivesOf(const std::vector<DoneLog>& logs) {
  std::map<std::string, double> starts;
  for (const DoneLog& log : logs) {
    auto& start = starts.try_emplace(log.dive, std::nan("")).first->second;
    TakeEarlier(log.start, &start);
  }
  return InOrder(starts);
}

// A joint fit to be made, and the logs that it is made without.
struct Fit {
  DiveTask task;
  std::vector<LeftOutLog> excluded;
  int place = 0;  // of the dive in the order of all dives
};

// By vehicle, DOF and the order of dives.
std::vector<Fit> FitsOf(const std::vector<DoneLog>& logs, const std::vector<std::string>& dives) {
  std::map<std::string, int> place_of;
  for (const std::string& dive : dives) {
    place_of.emplace(dive, static_cast<int>(place_of.size()));
  }
  std::map<std::tuple<std::string, Dof, int>, Fit> fits;
  for (const DoneLog& log : logs) {
    for (const DoneDof& dof : log.dofs) {
      const int place = place_of.at(log.dive);
      Fit& fit = fits[{log.vehicle, dof.dof, place}];
      fit.task.vehicle = log.vehicle;
      fit.task.dive = log.dive;
      fit.task.dof = dof.dof;
      fit.place = place;
      if (dof.why_left_out.empty()) {
        fit.task.logs.push_back(log.log);
        fit.task.logs.back().own_nmae = dof.own_nmae;
      } else {
        fit.excluded.push_back({log.log.path, dof.why_left_out});
      }
    }
  }
  std::vector<Fit> list;
  for (auto& [key, fit] : fits) list.push_back(std::move(fit));
  return list;
}

// The logs of the next dive of this vehicle and DOF; none if there is no next one.
std::vector<DiveLog> NextLogs(const std::vector<Fit>& fits, std::size_t i) {
  if (i + 1 == fits.size()) return {};
  const DiveTask &task = fits[i].task, &next = fits[i + 1].task;
  const bool follows = task.vehicle == next.vehicle && task.dof == next.dof;
  return follows ? next.logs : std::vector<DiveLog>();
}

// What the programs said of one dive and DOF.
struct FittedTask {
  DiveOutcome outcome;
  std::vector<PredictionRow> predictions;  // of the next dive
};

FittedTask RunFit(const DiveTask& task,
                  const std::vector<DiveLog>& next_logs,
                  const ProgramSettings& programs,
                  const RunBook& book) {
  FittedTask fitted = {.outcome = RunDiveJobs(task, programs, book), .predictions = {}};
  const std::optional<RunRecord>& identify = fitted.outcome.identify;
  if (!identify || !IsUsable(*identify)) return fitted;
  for (const DiveLog& log : next_logs) {
    fitted.predictions.push_back({task.dive,
                                  log.path,
                                  std::string(Name(task.dof)),
                                  PredictionNmae(identify->output, log, programs, book)});
  }
  return fitted;
}

}  // namespace

DiveBatch RunDives(const std::vector<DoneLog>& logs,
                   const LogBatchOptions& options,
                   int at_a_time,
                   Store* store,
                   const std::function<void(const BatchProgress&)>& show) {
  DiveBatch batch;
  batch.dives = DivesOf(logs);
  const std::vector<Fit> fits = FitsOf(logs, batch.dives);
  std::mutex mutex;
  UnfinishedRuns unfinished;
  const RunBook book = unfinished.Watch(BookOf(store, &mutex));
  BatchProgress progress = {
      .noun = "dive fit", .done = 0, .total = fits.size(), .last_failure = ""};
  std::vector<FittedTask> fitted_tasks(fits.size());
  RunInParallel(at_a_time, fits.size(), [&](std::size_t i) {
    fitted_tasks[i] = RunFit(fits[i].task, NextLogs(fits, i), options.programs, book);
    const std::lock_guard lock(mutex);
    ++progress.done;
    if (show) show(progress);
  });
  std::vector<FittedDive> fitted;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const DiveTask& task = fits[i].task;
    const DiveOutcome& outcome = fitted_tasks[i].outcome;
    std::ranges::move(RowsOfDive(task, outcome, fits[i].excluded),
                      std::back_inserter(batch.tables.dive_fits));
    std::ranges::move(fitted_tasks[i].predictions, std::back_inserter(batch.tables.predictions));
    if (!outcome.identify || !IsUsable(*outcome.identify)) continue;
    fitted.push_back({task.vehicle, fits[i].place, task.dof, outcome.identify->output});
  }

  batch.is_final = unfinished.IsEmpty() &&
                   std::ranges::all_of(logs, [](const DoneLog& log) { return log.is_final; });

  std::map<std::string, std::filesystem::path> vehicle_files;
  for (const DoneLog& log : logs) vehicle_files.try_emplace(log.vehicle, log.vehicle_file);
  AddChangesOfDives(fitted, batch.dives, vehicle_files, &batch.tables);
  return batch;
}

std::vector<std::string> DivesOf(const Tables& tables) {
  std::map<std::string, double> starts;
  for (const LogRow& row : tables.logs) {
    auto& start = starts.try_emplace(row.dive, std::nan("")).first->second;
    TakeEarlier(ParseUtc(row.start).value_or(std::nan("")), &start);
  }
  return InOrder(starts);
}

}  // namespace fathom
