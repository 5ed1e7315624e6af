// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/log_batch.h"

#include "fathom/archive/dives/path_text.h"
#include "fathom/archive/jobs/run_in_parallel.h"
#include "fathom/archive/jobs/unfinished_runs.h"
#include "fathom/archive/store/rows_of_log.h"
#include "fathom/base/exit_code.h"
#include "fathom/base/input_error.h"
#include "fathom/base/utc_time.h"
#include "fathom/log/log_content.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

// A log's vehicle: its name, and its file where it has one.
struct VehicleOfLog {
  std::string name;
  fs::path file;
};

// Nothing if the file cannot be read as a vehicle.
std::optional<std::string> NameIn(const fs::path& vehicle_file) {
  if (vehicle_file.empty()) return std::nullopt;
  try {
    return CleanText(ReadVehicleFile(vehicle_file).name);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// `named`: as log.yaml does. Logs in different folders name one file by different paths: the name
// in it counts. archive.yaml's file is of the logs that name no vehicle, or the one in it.
VehicleOfLog VehicleOf(const std::string& named,
                       const fs::path& place,
                       const ArchiveSettings& settings) {
  if (named.ends_with(".yaml")) {
    const fs::path file = place / named;
    return {NameIn(file).value_or(CleanText(named)), file};
  }
  const auto of_archive = NameIn(settings.vehicle);
  if (of_archive && (named.empty() || named == *of_archive)) return {*of_archive, settings.vehicle};
  return {CleanText(named), {}};
}

std::string WhyLeftOut(const DofRuns& runs, const std::vector<FindingRow>& findings) {
  if (!IsUsable(runs.compare) && runs.compare.exit_code != kExitNoFit) return WhyNot(runs.compare);
  for (const FindingRow& finding : findings) {
    if (finding.severity == "red" && finding.dof == Name(runs.dof)) return finding.text;
  }
  return "";
}

// Of the best source, in training; NaN if there is none.
double OwnNmae(Dof dof, const std::vector<ScoreRow>& scores) {
  double least = std::numeric_limits<double>::quiet_NaN();
  for (const ScoreRow& score : scores) {
    if (score.dof != Name(dof) || score.family != "output_error") continue;
    if (!(least <= score.nmae)) least = score.nmae;
  }
  return least;
}

LogRow RowOf(const LogOutcome& outcome, const DoneLog& log, const std::string& version) {
  return {.path = outcome.path,
          .dive = log.dive,
          .start = std::isfinite(log.start) ? FormatUtc(std::floor(log.start)) : "",
          .duration = outcome.survey ? outcome.survey->duration : kNoNumber,
          .content = outcome.content,
          .status = std::string(Name(outcome.state)),
          .message = outcome.message,
          .seconds = outcome.seconds,
          .peak_mb = outcome.peak_mb,
          .version = version,
          .vehicle = log.vehicle};
}

// What needs no program: a copy of another log, or one that cannot be read.
std::optional<LogOutcome> OutcomeWithoutRuns(const HashedLog& log) {
  LogOutcome outcome;
  outcome.path = log.path;
  outcome.place = log.log.place;
  outcome.content = log.content;
  if (!log.unreadable.empty()) {
    outcome.state = LogState::kUnreadable;
    outcome.message = log.unreadable;
    return outcome;
  }
  if (!log.duplicate_of.empty()) {
    outcome.state = LogState::kDuplicate;
    outcome.message = fmt::format("the same bytes as {}.", log.duplicate_of);
    return outcome;
  }
  return std::nullopt;
}

DoneLog DoneLogOf(const HashedLog& hashed,
                  const LogOutcome& outcome,
                  const Tables& rows,
                  const ArchiveSettings& settings) {
  DoneLog done;
  done.log = {.path = outcome.path, .place = outcome.place, .content = outcome.place_content};
  done.dive = DiveOfPath(hashed.log.path, settings);
  done.state = outcome.state;
  const std::string vehicle = outcome.survey ? outcome.survey->vehicle : "";
  // An import copies the vehicle file into the log.
  const fs::path place = hashed.log.is_recording ? outcome.place : fs::path(hashed.log.place);
  VehicleOfLog vehicle_of_log = VehicleOf(vehicle, place, settings);
  done.vehicle = std::move(vehicle_of_log.name);
  done.vehicle_file = std::move(vehicle_of_log.file);
  if (outcome.survey) {
    if (!outcome.survey->dive.empty()) done.dive = CleanText(outcome.survey->dive);
    done.start = outcome.survey->start;
  }
  for (const DofRuns& runs : outcome.dofs) {
    done.dofs.push_back(
        {runs.dof, WhyLeftOut(runs, rows.findings), OwnNmae(runs.dof, rows.scores)});
  }
  if (outcome.survey) {
    for (const SurveyedDof& dof : outcome.survey->dofs) {
      if (!dof.why_not.empty() && dof.may_help)
        done.dofs.push_back({.dof = dof.dof, .why_left_out = ""});
    }
  }
  return done;
}

void AddPages(const LogOutcome& outcome, const LogJobOptions& options, LogBatch* batch) {
  if (options.pages.empty()) return;
  for (const DofRuns& runs : outcome.dofs) {
    const std::string page = PageNameOf(outcome.path, runs.dof);
    std::error_code error;
    if (!fs::exists(options.pages / page, error)) continue;
    batch->pages[{outcome.path, std::string(Name(runs.dof))}] = page;
  }
}

}  // namespace

std::string DoneDigest(const HashedLog& log, const LogBatchOptions& options) {
  const ArchiveSettings& settings = options.settings;
  std::vector<std::string> texts = {
      log.content,
      log.unreadable,
      log.duplicate_of,
      options.programs.version,
      options.jobs.families,
      options.jobs.diagnose ? "diagnose" : "",
      settings.dive_pattern,
      fmt::format("{}", settings.dive_level.value_or(0)),
      settings.vehicle_name,
      options.vehicle_content,
      settings.dof ? std::string(Name(*settings.dof)) : "",
  };
  return DigestOf(texts);
}

RunBook BookOf(Store* store, std::mutex* mutex) {
  return {.find =
              [store, mutex](const std::string& key) {
                const std::lock_guard lock(*mutex);
                return store->FindRun(key);
              },
          .keep =
              [store, mutex](const RunRecord& run) {
                const std::lock_guard lock(*mutex);
                store->KeepRun(run);
              }};
}

LogBatch RunLogs(const std::vector<HashedLog>& logs,
                 const LogBatchOptions& options,
                 int at_a_time,
                 Store* store,
                 const std::function<void(const BatchProgress&)>& show) {
  LogBatch batch;
  batch.logs.resize(logs.size());
  const auto stored = store->DoneLogs();
  constexpr std::size_t kMostPending = 200;
  std::mutex mutex;  // of the store and what follows it
  std::vector<StoredLog> pending;
  BatchProgress progress = {.noun = "log", .done = 0, .total = logs.size(), .last_failure = ""};
  RunInParallel(at_a_time, logs.size(), [&](std::size_t i) {
    const HashedLog& log = logs[i];
    bool has_run = false;
    UnfinishedRuns unfinished;
    RunBook book = unfinished.Watch(BookOf(store, &mutex));
    book.keep = [&, keep = book.keep](const RunRecord& run) {
      has_run = true;
      keep(run);
    };
    std::optional<LogOutcome> outcome = OutcomeWithoutRuns(log);
    if (!outcome) outcome = RunLogJobs(log.log, log.content, options.jobs, options.programs, book);
    const Tables rows = RowsOfLog(*outcome);
    DoneLog done = DoneLogOf(log, *outcome, rows, options.settings);
    done.is_final = unfinished.IsEmpty();

    const std::lock_guard lock(mutex);
    const std::string digest = DoneDigest(log, options);
    const auto before = stored.find(log.path);
    if (has_run || before == stored.end() || before->second != digest) {
      pending.push_back(
          {RowOf(*outcome, done, options.programs.version), rows, done.is_final ? digest : ""});
    }
    // What was run is written at once. What was known goes together: each time takes a disk's wait.
    if (has_run || pending.size() >= kMostPending) {
      store->ReplaceLogs(pending);
      pending.clear();
    }
    AddPages(*outcome, options.jobs, &batch);
    if (has_run) ++batch.num_run;
    if (IsFailure(outcome->state)) {
      progress.last_failure = fmt::format("{}: {}", outcome->path, Name(outcome->state));
    }
    batch.logs[i] = std::move(done);
    ++progress.done;
    if (show) show(progress);
  });
  store->ReplaceLogs(pending);
  return batch;
}

}  // namespace fathom
