// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dive_batch.h"

#include "fathom/archive/changes_of_dives.h"
#include "fathom/archive/dives/dive_order.h"
#include "fathom/archive/store/rows_of_log.h"
#include "fathom/base/utc_time.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <optional>
#include <set>
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

std::vector<std::string> DivesOf(const std::vector<BatchLog>& logs) {
  std::map<std::string, double> starts;
  for (const BatchLog& log : logs) {
    auto& start = starts.try_emplace(log.dive, std::nan("")).first->second;
    TakeEarlier(log.start, &start);
  }
  return InOrder(starts);
}

// A joint fit to be made, and the logs that it is made without.
struct Fit {
  DiveTask task;
  std::vector<LeftOutLog> excluded;
};

using Fits = std::map<FitKey, Fit>;

std::map<std::string, int> PlacesOf(const std::vector<std::string>& dives) {
  std::map<std::string, int> place_of;
  for (const std::string& dive : dives) {
    place_of.emplace(dive, static_cast<int>(place_of.size()));
  }
  return place_of;
}

// By vehicle, DOF and the order of dives.
Fits FitsOf(const std::vector<BatchLog>& logs, const std::map<std::string, int>& place_of) {
  Fits fits;
  for (const BatchLog& log : logs) {
    for (const BatchDof& dof : log.dofs) {
      Fit& fit = fits[{log.vehicle, dof.dof, place_of.at(log.dive)}];
      fit.task.vehicle = log.vehicle;
      fit.task.dive = log.dive;
      fit.task.dof = dof.dof;
      if (dof.why_left_out.empty()) {
        fit.task.logs.push_back(log.log);
        fit.task.logs.back().own_nmae = dof.own_nmae;
      } else {
        fit.excluded.push_back({log.log.path, dof.why_left_out});
      }
    }
  }
  return fits;
}

// The fit of the next dive of the same vehicle and DOF; the end if there is none.
Fits::const_iterator NextDive(const Fits& fits, Fits::const_iterator fit) {
  const auto next = std::next(fit);
  if (next == fits.end()) return next;
  const auto& [vehicle, dof, place] = fit->first;
  const auto& [next_vehicle, next_dof, next_place] = next->first;
  return next_vehicle == vehicle && next_dof == dof ? next : fits.end();
}

// Places of the dives of each vehicle with logs that are not done.
using OpenPlaces = std::map<std::string, std::set<int>>;

OpenPlaces OpenPlacesOf(const std::vector<BatchLog>& logs,
                        const std::map<std::string, int>& place_of) {
  OpenPlaces places;
  for (const BatchLog& log : logs) {
    if (!log.is_done) places[log.vehicle].insert(place_of.at(log.dive));
  }
  return places;
}

// Whether no log of this dive is open, nor of the next one: one in between may make a dive the
// next.
bool MayBegin(const Fits& fits,
              Fits::const_iterator fit,
              Fits::const_iterator next,
              const OpenPlaces& open_places) {
  const auto& [vehicle, dof, place] = fit->first;
  const auto open = open_places.find(vehicle);
  if (open == open_places.end()) return true;
  const auto first = open->second.lower_bound(place);
  if (first == open->second.end()) return true;
  return next != fits.end() && *first > std::get<int>(next->first);
}

// Lets the model of a fit predict the logs of the next dive.
std::vector<Job> PredictionJobs(const DiveTask& task,
                                const std::vector<DiveLog>& next_logs,
                                const LogBatchOptions& options,
                                FittedTask* fitted,
                                DiveRuns* runs,
                                BatchSession* session) {
  std::vector<Job> jobs;
  for (const DiveLog& log : next_logs) {
    PredictionRow& row = fitted->predictions.emplace_back();
    row = {task.dive, log.path, std::string(Name(task.dof)), std::nan("")};
    jobs.push_back({[=, &options, &row]() -> std::vector<Job> {
      const RunBook book = runs->unfinished.Watch(BookOf(session));
      row.nmae = PredictionNmae(fitted->outcome.identify->output, log, options.programs, book);
      return {};
    }});
  }
  return jobs;
}

// Runs a fit.
std::vector<Job> RunFit(const DiveTask& task,
                        const std::vector<DiveLog>& next_logs,
                        const LogBatchOptions& options,
                        FittedTask* fitted,
                        DiveRuns* runs,
                        BatchSession* session) {
  const RunBook book = runs->unfinished.Watch(BookOf(session));
  fitted->outcome = RunDiveJobs(task, options.programs, book);
  const std::optional<RunRecord>& identify = fitted->outcome.identify;
  const std::lock_guard lock(session->mutex);
  ++runs->num_done;
  if (session->show && runs->are_shown) {
    session->show({.noun = "dive fit",
                   .done = runs->num_done,
                   .total = runs->fits.size(),
                   .last_failure = ""});
  }
  if (!identify || !IsUsable(*identify)) return {};
  fitted->predictions.reserve(next_logs.size());  // The jobs keep where each one lies.
  return PredictionJobs(task, next_logs, options, fitted, runs, session);
}

}  // namespace

std::vector<Job> NewDiveJobs(const std::vector<BatchLog>& logs,
                             const LogBatchOptions& options,
                             DiveRuns* runs,
                             BatchSession* session) {
  const auto place_of = PlacesOf(DivesOf(logs));
  const Fits fits = FitsOf(logs, place_of);
  const OpenPlaces open_places = OpenPlacesOf(logs, place_of);
  runs->are_shown = open_places.empty();
  std::vector<Job> jobs;
  for (auto fit = fits.begin(); fit != fits.end(); ++fit) {
    const auto next = NextDive(fits, fit);
    if (!MayBegin(fits, fit, next, open_places)) continue;
    const auto [fitted, is_new] = runs->fits.try_emplace(fit->first);
    if (!is_new) continue;
    const auto next_logs = next == fits.end() ? std::vector<DiveLog>() : next->second.task.logs;
    jobs.push_back({[=, task = fit->second.task, fitted = &fitted->second, &options] {
      return RunFit(task, next_logs, options, fitted, runs, session);
    }});
  }
  return jobs;
}

DiveBatch BatchOfDives(const std::vector<BatchLog>& logs, const DiveRuns& runs) {
  DiveBatch batch;
  batch.dives = DivesOf(logs);
  std::vector<FittedDive> fitted;
  for (const auto& [key, fit] : FitsOf(logs, PlacesOf(batch.dives))) {
    const FittedTask& run = runs.fits.at(key);
    std::ranges::move(RowsOfDive(fit.task, run.outcome, fit.excluded),
                      std::back_inserter(batch.tables.dive_fits));
    std::ranges::copy(run.predictions, std::back_inserter(batch.tables.predictions));
    const std::optional<RunRecord>& identify = run.outcome.identify;
    if (!identify || !IsUsable(*identify)) continue;
    fitted.push_back({fit.task.vehicle, std::get<int>(key), fit.task.dof, identify->output});
  }

  batch.is_final = runs.unfinished.IsEmpty() &&
                   std::ranges::all_of(logs, [](const BatchLog& log) { return log.is_final; });

  std::map<std::string, std::filesystem::path> vehicle_files;
  for (const BatchLog& log : logs) vehicle_files.try_emplace(log.vehicle, log.vehicle_file);
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
