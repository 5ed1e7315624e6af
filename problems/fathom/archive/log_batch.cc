// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/log_batch.h"

#include "fathom/archive/jobs/unfinished_runs.h"
#include "fathom/archive/known_logs.h"
#include "fathom/archive/store/rows_of_log.h"
#include "fathom/base/exit_code.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/base/utc_time.h"
#include "fathom/log/log_content.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
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

LogRow RowOf(const LogOutcome& outcome, const BatchLog& log, const std::string& version) {
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
  LogOutcome outcome = OutcomeOfFound(log.log, log.content);
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

// What its survey says.
BatchLog Surveyed(const HashedLog& hashed,
                  const LogOutcome& outcome,
                  const ArchiveSettings& settings) {
  BatchLog log;
  log.log = {.path = outcome.path, .place = outcome.place, .content = outcome.place_content};
  log.dive = DiveOfPath(hashed.log.path, settings);
  const std::string vehicle = outcome.survey ? outcome.survey->vehicle : "";
  // An import copies the vehicle file into the log.
  const fs::path place = hashed.log.is_recording ? outcome.place : fs::path(hashed.log.place);
  VehicleOfLog vehicle_of_log = VehicleOf(vehicle, place, settings);
  log.vehicle = std::move(vehicle_of_log.name);
  log.vehicle_file = std::move(vehicle_of_log.file);
  if (outcome.survey) {
    if (!outcome.survey->dive.empty()) log.dive = CleanText(outcome.survey->dive);
    log.start = outcome.survey->start;
  }
  return log;
}

std::vector<BatchDof> DofsOf(const LogOutcome& outcome, const Tables& rows) {
  std::vector<BatchDof> dofs;
  for (const DofRuns& runs : outcome.dofs) {
    dofs.push_back({runs.dof, WhyLeftOut(runs, rows.findings), OwnNmae(runs.dof, rows.scores)});
  }
  if (!outcome.survey) return dofs;
  for (const SurveyedDof& dof : outcome.survey->dofs) {
    if (!dof.why_not.empty() && dof.may_help) dofs.push_back({.dof = dof.dof, .why_left_out = ""});
  }
  return dofs;
}

void AddPages(const LogOutcome& outcome, const LogJobOptions& options, LogBatch* batch) {
  if (options.pages.empty()) return;
  const auto add = [&](const std::string& dofs) {
    const std::string page = PageNameOf(outcome.path, dofs);
    std::error_code error;
    if (fs::exists(options.pages / page, error)) batch->pages[{outcome.path, dofs}] = page;
  };
  for (const DofRuns& runs : outcome.dofs) add(std::string(Name(runs.dof)));
  if (outcome.coupled) add(outcome.coupled->dofs);
}

// The work on one log, which two jobs do: the second one runs the programs on it.
struct LogWork {
  UnfinishedRuns unfinished;
  bool has_run = false;
  RunBook book;
  LogOutcome outcome;
};

// The work on all logs. The jobs that it gives must not outlive it.
class Work {
 public:
  Work(const std::vector<HashedLog>& logs,
       const LogBatchOptions& options,
       const Followers& followers,
       BatchSession* session)
      : logs_(logs),
        options_(options),
        followers_(followers),
        session_(*session),
        stored_(session->store->DoneLogs()),
        known_(session->store->KnownLogs()),
        coupled_verdicts_(options.jobs.coupled_dofs ? session->store->CoupledVerdicts()
                                                    : std::map<std::string, std::string>()) {
    batch_.logs.resize(logs.size());
  }

  // The first jobs of all logs that are not known to be done.
  std::vector<Job> Begin() {
    const std::lock_guard lock(session_.mutex);
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < logs_.size(); ++i) {
      if (TakeKnown(i)) continue;
      jobs.push_back({[this, i] { return Prepare(i); }});
    }
    return jobs.empty() ? FollowersNow() : jobs;
  }

  LogBatch Result() {
    session_.store->ReplaceLogs(pending_);
    pending_.clear();
    return std::move(batch_);
  }

 private:
  // What is kept of a log that is done; null if it is not.
  const KnownLog* KnownOf(const HashedLog& log) const {
    const auto known = known_.find(log.path);
    const auto stored = stored_.find(log.path);
    if (known == known_.end() || stored == stored_.end()) return nullptr;
    return stored->second == DoneDigest(log, options_) ? &known->second : nullptr;
  }

  // Takes log i from what is kept of it; false if it has to be looked at. Pages have to be.
  bool TakeKnown(std::size_t i) {
    const HashedLog& log = logs_[i];
    const KnownLog* known = options_.jobs.pages.empty() ? KnownOf(log) : nullptr;
    const auto outcome = known ? OutcomeOf(*known, log, options_.jobs) : std::nullopt;
    if (!outcome) return false;
    batch_.logs[i] = Surveyed(log, *outcome, options_.settings);
    if (const auto verdict = coupled_verdicts_.find(log.path); verdict != coupled_verdicts_.end()) {
      batch_.logs[i].coupled = CoupledInVerdict(verdict->second);
    }
    ++num_surveyed_;
    EndWith(*outcome, DofsOf(*known), &batch_.logs[i]);
    return true;
  }

  // The first job of log i.
  std::vector<Job> Prepare(std::size_t i) {
    const HashedLog& log = logs_[i];
    const auto work = std::make_shared<LogWork>();
    work->book = work->unfinished.Watch(BookOf(&session_));
    work->book.keep = [work = work.get(), keep = work->book.keep](const RunRecord& run) {
      work->has_run = true;
      keep(run);
    };
    const std::optional<LogOutcome> known = OutcomeWithoutRuns(log);
    work->outcome =
        known ? *known
              : PrepareLog(log.log, log.content, options_.jobs, options_.programs, work->book);
    BatchLog surveyed = Surveyed(log, work->outcome, options_.settings);
    const bool goes_on = work->outcome.state == LogState::kOk;

    const std::lock_guard lock(session_.mutex);
    batch_.logs[i] = std::move(surveyed);
    ++num_surveyed_;
    if (!goes_on) return Finish(i, *work);
    std::vector<Job> jobs = FollowersNow();
    jobs.insert(jobs.begin(), Job{[this, i, work] { return RunProgramsOn(i, *work); }});
    return jobs;
  }

  std::vector<Job> RunProgramsOn(std::size_t i, LogWork& work) {
    work.outcome =
        RunPrograms(std::move(work.outcome), options_.jobs, options_.programs, work.book);
    const std::lock_guard lock(session_.mutex);
    return Finish(i, work);
  }

  // Under the mutex.
  std::vector<Job> Finish(std::size_t i, const LogWork& work) {
    constexpr std::size_t kMostPending = 200;
    const HashedLog& hashed = logs_[i];
    const LogOutcome& outcome = work.outcome;
    const Tables rows = RowsOfLog(outcome);
    BatchLog& log = batch_.logs[i];
    log.is_final = work.unfinished.IsEmpty();
    if (outcome.coupled && IsUsable(outcome.coupled->diagnose)) {
      log.coupled = CoupledInVerdict(outcome.coupled->diagnose.output);
    }
    EndWith(outcome, DofsOf(outcome, rows), &log);
    if (work.has_run || KnownOf(hashed) == nullptr) {
      pending_.push_back({.row = RowOf(outcome, log, options_.programs.version),
                          .rows = rows,
                          .known = KnownLogOf(outcome, log.dofs),
                          .done = log.is_final ? DoneDigest(hashed, options_) : ""});
    }
    // What was run is written at once. What was known goes together: each time takes a disk's wait.
    if (work.has_run || pending_.size() >= kMostPending) {
      session_.store->ReplaceLogs(pending_);
      pending_.clear();
    }
    AddPages(outcome, options_.jobs, &batch_);
    if (work.has_run) ++batch_.num_run;
    return FollowersNow();
  }

  void EndWith(const LogOutcome& outcome, std::vector<BatchDof> dofs, BatchLog* log) {
    log->state = outcome.state;
    log->dofs = std::move(dofs);
    log->is_done = true;
    ShowProgress(outcome);
  }

  void ShowProgress(const LogOutcome& outcome) {
    if (IsFailure(outcome.state)) {
      last_failure_ = fmt::format("{}: {}", outcome.path, Name(outcome.state));
    }
    ++num_done_;
    if (!session_.show) return;
    session_.show(
        {.noun = "log", .done = num_done_, .total = logs_.size(), .last_failure = last_failure_});
  }

  std::vector<Job> FollowersNow() const {
    if (!followers_ || num_surveyed_ < logs_.size()) return {};
    return followers_(batch_.logs);
  }

  const std::vector<HashedLog>& logs_;
  const LogBatchOptions& options_;
  const Followers& followers_;
  BatchSession& session_;
  const std::map<std::string, std::string> stored_;
  const std::map<std::string, KnownLog> known_;
  const std::map<std::string, std::string> coupled_verdicts_;  // of known logs
  LogBatch batch_;
  std::vector<StoredLog> pending_;
  std::size_t num_surveyed_ = 0, num_done_ = 0;
  std::string last_failure_;
};

}  // namespace

std::string DoneDigest(const HashedLog& log, const LogBatchOptions& options) {
  const ArchiveSettings& settings = options.settings;
  std::vector<std::string> texts = {
      log.content,
      log.unreadable,
      log.duplicate_of,
      options.programs.version,
      options.jobs.families,
      options.jobs.weighting,
      options.jobs.diagnose ? "diagnose" : "",
      settings.dive_pattern,
      fmt::format("{}", settings.dive_level.value_or(0)),
      settings.vehicle_name,
      options.vehicle_content,
      settings.dof ? std::string(Name(*settings.dof)) : "",
  };
  // What was done before there were coupled models stays done.
  if (const auto& dofs = options.jobs.coupled_dofs) texts.push_back("dofs=" + JoinedNames(*dofs));
  return DigestOf(texts);
}

LogBatch RunLogs(const std::vector<HashedLog>& logs,
                 const LogBatchOptions& options,
                 int at_a_time,
                 const Followers& followers,
                 BatchSession* session) {
  Work work(logs, options, followers, session);
  RunInParallel(at_a_time, work.Begin());
  return work.Result();
}

}  // namespace fathom
