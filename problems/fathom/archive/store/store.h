// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/jobs/run_record.h"
#include "fathom/archive/store/known_log.h"
#include "fathom/archive/store/tables.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace fathom {

// A log's files as they were when their content was hashed.
struct KnownContent {
  std::string stamps;  // names, sizes and times of change
  std::string content;
};

// The rows of one log.
struct StoredLog {
  LogRow row;
  Tables rows;       // without `logs`
  KnownLog known;    // of the same log
  std::string done;  // what they were made of, as a digest
};

// The results of an archive, an SQLite database: the public tables (tables.h), and what they are
// made of: `runs`, which holds what the programs wrote, and `files`; known_log.h. It keeps a
// rollback journal and no write-ahead log, which would not do on a network file system. What a
// function writes is there as a whole, or not at all, whenever the process ends. For one thread at
// a time. What SQLite refuses (a disk that is full, a damaged file) is an InputError that names the
// file.
class Store {
 public:
  // Opens a database, or makes one. Throws InputError, naming the file, if that is not possible or
  // it is something else.
  explicit Store(const std::filesystem::path& file);
  ~Store();

  std::optional<RunRecord> FindRun(const std::string& key);
  void KeepRun(const RunRecord& run);

  std::map<std::string, KnownContent> KnownContents() const;  // by path
  void KeepContents(const std::map<std::string, KnownContent>& contents);

  // Rows of logs in all tables that have a column `log`, and in `logs`.
  void ReplaceLogs(const std::vector<StoredLog>& logs);

  // StoredLog::done, by path.
  std::map<std::string, std::string> DoneLogs() const;

  // StoredLog::known, by path.
  std::map<std::string, KnownLog> KnownLogs() const;

  // VerdictRow::json of the coupled models, by path.
  std::map<std::string, std::string> CoupledVerdicts() const;

  // Takes out the logs that are not among these paths.
  void RemoveOtherLogs(const std::vector<std::string>& paths);

  // dive_fits, predictions, changes and outliers as a whole. `done` as above, of all dives
  // together.
  void ReplaceDives(const Tables& tables, const std::string& done);
  std::string DoneDives() const;

  // The public tables, without VerdictRow::json. Logs, and what is of a log, are by its path.
  Tables ReadTables() const;

  // Of these only what a summary takes: logs, scores, dive_fits, verdicts, causes,
  // findings and changes.
  Tables ReadSummaryTables() const;

  // Takes over the runs and contents of another results file that this one lacks. Throws InputError
  // if it cannot be read.
  void Merge(const std::filesystem::path& file);

  // From now on looks there too for runs and contents that this file lacks, and takes over those
  // runs that are asked for. Throws InputError if it cannot be read.
  void LookInto(const std::filesystem::path& file);

 private:
  std::unique_ptr<SQLite::Database> database_;
  std::vector<std::unique_ptr<SQLite::Database>> others_;
};

// The public tables of a results file, or what a summary takes of them. Throws InputError as Store
// does.
Tables ReadResults(const std::filesystem::path& file);
Tables ReadSummary(const std::filesystem::path& file);

}  // namespace fathom
