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

// A fit that was begun, and what its jobs use.
struct BegunFit {
  DiveTask task;
  std::vector<DiveLog> next_logs;  // of the next dive, which its model predicts
  FittedTask* fitted = nullptr;    // in `runs`
  DiveRuns* runs = nullptr;
  const ProgramSettings* programs = nullptr;
  BatchSession* session = nullptr;

  RunBook Book() const { return runs->unfinished.Watch(BookOf(session)); }
};

// Lets the model of the fit predict.
std::vector<Job> PredictionJobs(const BegunFit& fit) {
  std::vector<Job> jobs;
  fit.fitted->predictions.reserve(fit.next_logs.size());  // The jobs keep where each one lies.
  for (const DiveLog& log : fit.next_logs) {
    PredictionRow& row = fit.fitted->predictions.emplace_back();
    row = {fit.task.dive, log.path, std::string(Name(fit.task.dof)), std::nan("")};
    jobs.push_back({[fit, log, &row]() -> std::vector<Job> {
      const std::string& model = fit.fitted->outcome.identify->output;
      row.nmae = PredictionNmae(model, log, *fit.programs, fit.Book());
      return {};
    }});
  }
  return jobs;
}

void CountDone(DiveRuns* runs, BatchSession* session) {
  const std::lock_guard lock(session->mutex);
  ++runs->num_done;
  if (!session->show || !runs->are_shown) return;
  session->show({.noun = "dive fit",
                 .done = runs->num_done,
                 .total = runs->fits.size() + runs->coupled.size(),
                 .last_failure = ""});
}

std::vector<Job> RunFit(const BegunFit& fit) {
  fit.fitted->outcome = RunDiveJobs(fit.task, *fit.programs, fit.Book());
  CountDone(fit.runs, fit.session);
  const std::optional<RunRecord>& identify = fit.fitted->outcome.identify;
  return identify && IsUsable(*identify) ? PredictionJobs(fit) : std::vector<Job>();
}

// Those that may begin and have not begun.
std::vector<Job> NewCoupledJobs(const std::vector<BatchLog>& logs,
                                const std::map<std::string, int>& place_of,
                                const ProgramSettings& programs,
                                DiveRuns* runs,
                                BatchSession* session) {
  std::vector<Job> jobs;
  for (const auto& [key, task] : CoupledDiveTasks(logs, place_of)) {
    const auto [fitted, is_new] = runs->coupled.try_emplace(key);
    if (!is_new) continue;
    std::optional<RunRecord>* const result = &fitted->second;
    jobs.push_back({[=, task = task, &programs]() -> std::vector<Job> {
      *result = RunCoupledDiveJob(task, programs, runs->unfinished.Watch(BookOf(session)));
      CountDone(runs, session);
      return {};
    }});
  }
  return jobs;
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
  std::vector<Job> jobs = NewCoupledJobs(logs, place_of, options.programs, runs, session);
  for (auto fit = fits.begin(); fit != fits.end(); ++fit) {
    const auto next = NextDive(fits, fit);
    if (!MayBegin(fits, fit, next, open_places)) continue;
    const auto [fitted, is_new] = runs->fits.try_emplace(fit->first);
    if (!is_new) continue;
    BegunFit begun = {.task = fit->second.task,
                      .next_logs = {},
                      .fitted = &fitted->second,
                      .runs = runs,
                      .programs = &options.programs,
                      .session = session};
    begun.task.weighting = options.jobs.weighting;
    if (next != fits.end()) begun.next_logs = next->second.task.logs;
    jobs.push_back({[begun = std::move(begun)] { return RunFit(begun); }});
  }
  return jobs;
}

DiveBatch BatchOfDives(const std::vector<BatchLog>& logs, const DiveRuns& runs) {
  DiveBatch batch;
  batch.dives = DivesOf(logs);
  std::vector<FittedDive> fitted;
  const auto place_of = PlacesOf(batch.dives);
  for (const auto& [key, fit] : FitsOf(logs, place_of)) {
    const FittedTask& run = runs.fits.at(key);
    std::ranges::move(RowsOfDive(fit.task, run.outcome, fit.excluded),
                      std::back_inserter(batch.tables.dive_fits));
    std::ranges::copy(run.predictions, std::back_inserter(batch.tables.predictions));
    const std::optional<RunRecord>& identify = run.outcome.identify;
    if (!identify || !IsUsable(*identify)) continue;
    fitted.push_back(
        {fit.task.vehicle, std::get<int>(key), std::string(Name(fit.task.dof)), identify->output});
  }
  for (const auto& [key, task] : CoupledDiveTasks(logs, place_of)) {
    const RunRecord& run = *runs.coupled.at(key);
    std::ranges::move(RowsOfCoupledDive(task, run), std::back_inserter(batch.tables.dive_fits));
    if (!IsUsable(run)) continue;
    fitted.push_back({task.vehicle, std::get<int>(key), task.dofs, run.output});
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
