// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/batch.h"

#include "fathom/archive/batch_lock.h"
#include "fathom/archive/dive_batch.h"
#include "fathom/archive/dives/archive_settings.h"
#include "fathom/archive/dives/walk_archive.h"
#include "fathom/archive/jobs/log_jobs.h"
#include "fathom/archive/jobs/run_in_parallel.h"
#include "fathom/archive/log_batch.h"
#include "fathom/archive/log_contents.h"
#include "fathom/archive/store/store.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/files/yaml_without.h"
#include "fathom/base/input_error.h"
#include "fathom/log/log_content.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

void RequireValid(const BatchOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("--{}.", problems.front()));
  }
}

bool LiesIn(const fs::path& inner, const fs::path& outer) {
  const fs::path a = fs::weakly_canonical(inner), b = fs::weakly_canonical(outer);
  return std::mismatch(b.begin(), b.end(), a.begin(), a.end()).first == b.end();
}

void RequireOutside(const BatchOptions& options) {
  RequireOutsideArchive("results", options.results, options.archive);
  RequireOutsideArchive("report", options.pages, options.archive);
}

bool IsOf(const Shard& shard, const HashedLog& log) {
  // The digits of what cannot be read are missing: the first shard tells of it.
  const std::string digits = log.content.empty() ? "0" : log.content.substr(0, 15);
  const auto number = std::strtoull(digits.c_str(), nullptr, 16);
  return number % static_cast<unsigned long long>(shard.count) ==
         static_cast<unsigned long long>(shard.index);
}

// The logs of the archive, or of the shard.
std::vector<HashedLog> Hashed(const FoundArchive& found,
                              const BatchOptions& options,
                              Store* store) {
  std::vector<HashedLog> logs = HashLogs(found.logs, options.rehash, store);
  for (const UnreadablePlace& place : found.unreadable) {
    logs.push_back({.log = {options.archive / place.path, place.path},
                    .path = PathText(place.path),
                    .content = "",
                    .unreadable = "the folder cannot be read: " + place.message,
                    .duplicate_of = ""});
  }
  if (options.shard) {
    std::erase_if(logs, [&](const HashedLog& log) { return !IsOf(*options.shard, log); });
  }
  return logs;
}

LogBatchOptions LogOptionsOf(const BatchOptions& options, const ArchiveSettings& settings) {
  LogBatchOptions of_logs;
  of_logs.settings = settings;
  if (!settings.vehicle.empty()) {
    ReadVehicleFile(settings.vehicle);  // says what is wrong with it
    of_logs.vehicle_content = ContentOf(settings.vehicle);
    of_logs.programs.vehicle = fs::absolute(settings.vehicle);
    // Its name changes no number.
    of_logs.programs.vehicle_content = DigestOf(YamlWithout(ReadFile(settings.vehicle), "name"));
  }
  of_logs.jobs.families = options.families;
  of_logs.jobs.weighting = options.weighting;
  of_logs.jobs.diagnose = options.diagnose;
  of_logs.jobs.coupled_dofs = options.coupled_dofs;
  of_logs.jobs.dof = settings.dof;
  of_logs.jobs.pages = options.pages;
  of_logs.jobs.made = options.results.string() + ".logs";
  of_logs.programs.tools = options.tools;
  of_logs.programs.work = options.results.string() + ".work";
  of_logs.programs.version = options.version;
  of_logs.programs.limits.wall_time = options.time_limit;
  of_logs.programs.limits.memory = 1e6 * options.memory_limit;
  return of_logs;
}

// What decides the tables of whole dives: every log in its place.
std::string DigestOfAll(const std::vector<HashedLog>& logs, const LogBatchOptions& options) {
  std::vector<std::string> digests;
  for (const HashedLog& log : logs) {
    digests.push_back(log.path);
    digests.push_back(DoneDigest(log, options));
  }

  return DigestOf(digests);
}

bool IsDone(const std::map<std::string, std::string>& done,
            const HashedLog& log,
            const LogBatchOptions& options) {
  const auto found = done.find(log.path);
  return found != done.end() && found->second == DoneDigest(log, options);
}

// Takes the stored states of an archive in which nothing is to be done.
void CountStored(const Tables& tables, BatchSummary* summary) {
  for (const LogRow& row : tables.logs) {
    if (const auto state = LogStateFromName(row.status)) ++summary->states[*state];
  }
}

// Results that are there forget the logs of an archive that is empty now; none are begun for it.
FoundArchive WalkArchiveOf(const BatchOptions& options, const ArchiveSettings& settings) {
  FoundArchive found = WalkArchive(options.archive, settings);
  if (!fs::exists(options.results)) RequireAnyLog(found, options.archive);
  return found;
}

// The archive, hashed, and the results, which nobody else writes meanwhile. The archive is read
// first: results of one that cannot be used are not begun.
struct OpenBatch {
  ArchiveSettings settings;
  FoundArchive found;
  LogBatchOptions of_logs;
  BatchLock lock;
  Store store;
  std::vector<HashedLog> logs;

  explicit OpenBatch(const BatchOptions& options)
      : settings(ReadArchiveSettings(options.archive)),
        found(WalkArchiveOf(options, settings)),
        of_logs(LogOptionsOf(options, settings)),
        lock(options.results),
        store(options.results) {
    for (const fs::path& file : options.merge) {
      // A part holds only what belongs to it.
      options.shard ? store.LookInto(file) : store.Merge(file);
    }
    logs = Hashed(found, options, &store);
  }
};

void RequireUsable(const BatchOptions& options) {
  RequireValid(options);
  RequireOutside(options);
  RequireWritableFile(options.results);
}

}  // namespace

std::vector<std::string> BatchOptions::Problems() const {
  std::vector<std::string> problems;
  const auto require = [&](bool holds, std::string problem) {
    if (!holds) problems.push_back(std::move(problem));
  };
  require(jobs >= 1 && jobs <= 1024, fmt::format("jobs: is {}, expected 1 to 1024", jobs));
  require(time_limit > 0.0, fmt::format("time_limit: is {}, expected seconds above 0", time_limit));
  require(memory_limit > 0.0,
          fmt::format("memory_limit: is {}, expected megabytes above 0", memory_limit));
  if (shard) {
    require(
        shard->count >= 1 && shard->index >= 0 && shard->index < shard->count,
        fmt::format(
            "shard: is {}/{}, expected i/N with i from 0 to N - 1", shard->index, shard->count));
  }
  return problems;
}

void RequireOutsideArchive(std::string_view flag, const fs::path& place, const fs::path& archive) {
  if (place.empty() || !LiesIn(place, archive)) return;
  throw InputError(fmt::format(
      "--{}={}: lies in the archive, into which nothing is written, expected a place elsewhere.",
      flag,
      place.string()));
}

BatchSummary RunBatch(const BatchOptions& options,
                      const std::function<void(const BatchProgress&)>& show) {
  RequireUsable(options);
  OpenBatch batch(options);
  Store& store = batch.store;
  const std::vector<HashedLog>& all = batch.logs;
  const WorkFolder work(batch.of_logs.programs.work);

  BatchSummary summary;
  summary.other_files = batch.found.other_files;
  summary.nearly_logs = batch.found.nearly_logs;
  std::vector<std::string> paths;
  for (const HashedLog& log : all) paths.push_back(log.path);
  store.RemoveOtherLogs(paths);

  const auto done = store.DoneLogs();
  const bool all_done = std::ranges::all_of(
      all, [&](const HashedLog& log) { return IsDone(done, log, batch.of_logs); });
  const std::string digest = DigestOfAll(all, batch.of_logs);
  const bool needs_pages = !options.pages.empty();
  if (all_done && !needs_pages && (options.shard || store.DoneDives() == digest)) {
    const Tables tables = store.ReadSummaryTables();
    CountStored(tables, &summary);
    if (!options.shard) summary.dives = DivesOf(tables);
    return summary;
  }

  BatchSession session = {.store = &store, .show = show, .mutex = {}};
  DiveRuns dive_runs;
  Followers followers;
  if (!options.shard) {
    followers = [&](const std::vector<BatchLog>& logs) {
      return NewDiveJobs(logs, batch.of_logs, &dive_runs, &session);
    };
  }
  LogBatch logs = RunLogs(all, batch.of_logs, options.jobs, followers, &session);
  summary.num_run = logs.num_run;
  for (const BatchLog& log : logs.logs) ++summary.states[log.state];
  summary.pages = std::move(logs.pages);
  if (options.shard) return summary;
  DiveBatch dives = BatchOfDives(logs.logs, dive_runs);
  store.ReplaceDives(dives.tables, dives.is_final ? digest : "");
  summary.dives = std::move(dives.dives);
  return summary;
}

BatchPlan PlanBatch(const BatchOptions& options) {
  RequireUsable(options);
  OpenBatch batch(options);
  const auto done = batch.store.DoneLogs();
  std::set<std::string> to_do;
  for (const HashedLog& log : batch.logs) {
    if (!IsDone(done, log, batch.of_logs)) to_do.insert(log.path);
  }
  BatchPlan plan;
  plan.num_logs = batch.logs.size();
  plan.num_to_do = to_do.size();
  plan.other_files = batch.found.other_files;
  plan.nearly_logs = batch.found.nearly_logs;
  for (const LogRow& row : batch.store.ReadSummaryTables().logs) {
    if (to_do.contains(row.path)) ++plan.done_by_version[row.version];
  }
  return plan;
}

}  // namespace fathom
