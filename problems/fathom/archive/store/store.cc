// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/store/store.h"

#include "fathom/archive/store/table_io.h"
#include "fathom/base/input_error.h"

#include <array>
#include <set>
#include <string_view>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kFormat = 1;                // PRAGMA user_version
constexpr int kApplication = 0x46544d31;  // PRAGMA application_id: "FTM1"
constexpr int kCacheKb = 256;             // PRAGMA cache_size; SQLite's own is 2000

constexpr const char* kOwnTables = R"(
  CREATE TABLE IF NOT EXISTS runs(key TEXT PRIMARY KEY, program TEXT, arguments TEXT, version TEXT,
    limits TEXT, "end" INTEGER, exit_code INTEGER, signal INTEGER, seconds REAL, peak_mb REAL,
    output TEXT, message TEXT) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS files(path TEXT PRIMARY KEY, stamps TEXT, content TEXT) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS done(name TEXT PRIMARY KEY, digest TEXT) WITHOUT ROWID;
)";

// In `done`, of the dives; a path never is empty.
constexpr const char* kDives = "";

// What `work` on a database gives. Throws InputError, naming the file, for what SQLite says.
template <typename Work>
auto Named(const SQLite::Database& database, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw InputError(fmt::format("{}: {}.", database.getFilename(), error.what()));
  }
}

template <typename Row>
void SelectInto(SQLite::Database* database, const char* order, std::vector<Row>* rows) {
  *rows = Select<Row>(database, ColumnsOf<Row>().names, order);
}

// Logs are written as they are done, the rows of one log or of all dives together in their order.
constexpr const char* kByPath = "path";
constexpr const char* kByLog = "log, rowid";
constexpr const char* kAsWritten = "rowid";

// Without their files, which are long.
std::vector<VerdictRow> SelectVerdicts(SQLite::Database* database) {
  return Select<VerdictRow>(database, "log, dof, verdict, sentence, ''", kByLog);
}

constexpr std::array<const char*, 8> kTablesOfLogs = {
    "fits", "scores", "verdicts", "causes", "findings", "known_logs", "known_dofs", "done"};

void DeleteLog(const std::string& path, SQLite::Database* database) {
  for (const char* table : kTablesOfLogs) {
    const bool is_done = std::string_view(table) == "done";
    SQLite::Statement erase(
        *database, fmt::format("DELETE FROM {} WHERE {} = ?", table, is_done ? "name" : "log"));
    erase.bind(1, path);
    erase.exec();
  }
  SQLite::Statement erase(*database, "DELETE FROM logs WHERE path = ?");
  erase.bind(1, path);
  erase.exec();
}

void SetDone(const std::string& name, const std::string& digest, SQLite::Database* database) {
  SQLite::Statement insert(*database, "INSERT OR REPLACE INTO done VALUES(?, ?)");
  insert.bind(1, name);
  insert.bind(2, digest);
  insert.exec();
}

// Refuses a database that is not of this kind or of a later one.
void RequireOurs(const std::filesystem::path& file, SQLite::Database* database) {
  const int application = database->execAndGet("PRAGMA application_id").getInt();
  const int format = database->execAndGet("PRAGMA user_version").getInt();
  const int num_tables = database->execAndGet("SELECT count(*) FROM sqlite_master").getInt();
  if (application == 0 && format == 0 && num_tables == 0) return;
  if (application != kApplication) {
    throw InputError(fmt::format(
        "{}: is a database of another program, expected one of fathom_batch.", file.string()));
  }
  if (format != kFormat) {
    throw InputError(
        fmt::format("{}: has format {}, expected {}: another version of Fathom wrote it.",
                    file.string(),
                    format,
                    kFormat));
  }
}

// The run of that key in one database.
std::optional<RunRecord> FindRunIn(SQLite::Database* database, const std::string& key) {
  return Named(*database, [&] {
    SQLite::Statement select(*database,
                             "SELECT key, program, arguments, version, limits, \"end\", exit_code, "
                             "signal, seconds, peak_mb, output, message FROM runs WHERE key = ?");
    select.bind(1, key);
    if (!select.executeStep()) return std::optional<RunRecord>();
    RunRecord run;
    run.key = select.getColumn(0).getString();
    run.program = select.getColumn(1).getString();
    run.arguments = select.getColumn(2).getString();
    run.version = select.getColumn(3).getString();
    run.limits = select.getColumn(4).getString();
    run.end = static_cast<ChildEnd>(select.getColumn(5).getInt());
    run.exit_code = select.getColumn(6).getInt();
    run.signal = select.getColumn(7).getInt();
    run.seconds = select.getColumn(8).getDouble();
    run.peak_mb = select.getColumn(9).getDouble();
    run.output = select.getColumn(10).getString();
    run.message = select.getColumn(11).getString();
    return std::optional(std::move(run));
  });
}

void AddKnownContents(SQLite::Database* database, std::map<std::string, KnownContent>* known) {
  Named(*database, [&] {
    SQLite::Statement select(*database, "SELECT path, stamps, content FROM files");
    while (select.executeStep()) {
      known->try_emplace(
          select.getColumn(0).getString(),
          KnownContent{select.getColumn(1).getString(), select.getColumn(2).getString()});
    }
  });
}

}  // namespace

Store::Store(const std::filesystem::path& file) {
  try {
    database_ = std::make_unique<SQLite::Database>(
        file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, 60000);
    RequireOurs(file, database_.get());
    database_->exec(fmt::format("PRAGMA cache_size = -{}", kCacheKb));
    SQLite::Transaction transaction(*database_);
    database_->exec(fmt::format("PRAGMA application_id = {}", kApplication));
    database_->exec(fmt::format("PRAGMA user_version = {}", kFormat));
    database_->exec(kOwnTables);
    CreateTable<LogRow>(database_.get());
    CreateTable<FitRow>(database_.get());
    CreateTable<DiveFitRow>(database_.get());
    CreateTable<ScoreRow>(database_.get());
    CreateTable<VerdictRow>(database_.get());
    CreateTable<CauseRow>(database_.get());
    CreateTable<FindingRow>(database_.get());
    CreateTable<PredictionRow>(database_.get());
    CreateTable<ChangeRow>(database_.get());
    CreateTable<OutlierRow>(database_.get());
    CreateTable<KnownLogRow>(database_.get());
    CreateTable<KnownDofRow>(database_.get());
    for (const std::string_view table : kTablesOfLogs) {
      if (table == "done") continue;
      database_->exec(fmt::format("CREATE INDEX IF NOT EXISTS {0}_by_log ON {0}(log)", table));
    }
    database_->exec("CREATE INDEX IF NOT EXISTS logs_by_path ON logs(path)");
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    throw InputError(
        fmt::format("{}: cannot be used as a database: {}.", file.string(), error.what()));
  }
}

Store::~Store() = default;

std::optional<RunRecord> Store::FindRun(const std::string& key) {
  auto own = FindRunIn(database_.get(), key);
  if (own && IsFinal(*own)) return own;
  for (const auto& other : others_) {
    auto run = FindRunIn(other.get(), key);
    if (!run || (own && !IsFinal(*run))) continue;
    KeepRun(*run);
    return run;
  }
  return own;
}

void Store::KeepRun(const RunRecord& run) {
  Named(*database_, [&] {
    SQLite::Statement insert(
        *database_, "INSERT OR REPLACE INTO runs VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, run.key);
    insert.bind(2, run.program);
    insert.bind(3, run.arguments);
    insert.bind(4, run.version);
    insert.bind(5, run.limits);
    insert.bind(6, static_cast<int>(run.end));
    insert.bind(7, run.exit_code);
    insert.bind(8, run.signal);
    insert.bind(9, run.seconds);
    insert.bind(10, run.peak_mb);
    insert.bind(11, run.output);
    insert.bind(12, run.message);
    insert.exec();
  });
}

std::map<std::string, KnownContent> Store::KnownContents() const {
  std::map<std::string, KnownContent> known;
  AddKnownContents(database_.get(), &known);
  for (const auto& other : others_) AddKnownContents(other.get(), &known);
  return known;
}

void Store::KeepContents(const std::map<std::string, KnownContent>& contents) {
  Named(*database_, [&] {
    if (contents.empty()) return;
    SQLite::Transaction transaction(*database_);
    SQLite::Statement insert(*database_, "INSERT OR REPLACE INTO files VALUES(?, ?, ?)");
    for (const auto& [path, known] : contents) {
      insert.bind(1, path);
      insert.bind(2, known.stamps);
      insert.bind(3, known.content);
      insert.exec();
      insert.reset();
    }
    transaction.commit();
  });
}

void Store::ReplaceLogs(const std::vector<StoredLog>& logs) {
  Named(*database_, [&] {
    if (logs.empty()) return;
    SQLite::Transaction transaction(*database_);
    for (const StoredLog& log : logs) {
      DeleteLog(log.row.path, database_.get());
      Insert(std::vector<LogRow>{log.row}, database_.get());
      Insert(log.rows.fits, database_.get());
      Insert(log.rows.scores, database_.get());
      Insert(log.rows.verdicts, database_.get());
      Insert(log.rows.causes, database_.get());
      Insert(log.rows.findings, database_.get());
      Insert(std::vector<KnownLogRow>{log.known.row}, database_.get());
      Insert(log.known.dofs, database_.get());
      SetDone(log.row.path, log.done, database_.get());
    }
    transaction.commit();
  });
}

std::map<std::string, std::string> Store::DoneLogs() const {
  return Named(*database_, [&] {
    SQLite::Statement select(*database_, "SELECT name, digest FROM done WHERE name <> ?");
    select.bind(1, kDives);
    std::map<std::string, std::string> done;
    while (select.executeStep()) {
      done[select.getColumn(0).getString()] = select.getColumn(1).getString();
    }
    return done;
  });
}

std::map<std::string, KnownLog> Store::KnownLogs() const {
  return Named(*database_, [&] {
    std::vector<KnownLogRow> rows;
    std::vector<KnownDofRow> dofs;
    SelectInto(database_.get(), kAsWritten, &rows);
    SelectInto(database_.get(), kAsWritten, &dofs);
    std::map<std::string, KnownLog> known;
    for (KnownLogRow& row : rows) known[row.log].row = std::move(row);
    for (KnownDofRow& dof : dofs) known[dof.log].dofs.push_back(std::move(dof));
    return known;
  });
}

std::map<std::string, std::string> Store::CoupledVerdicts() const {
  return Named(*database_, [&] {
    std::map<std::string, std::string> verdicts;
    SQLite::Statement query(*database_, "SELECT log, json FROM verdicts WHERE dof LIKE '%,%'");
    while (query.executeStep()) {
      verdicts[query.getColumn(0).getString()] = query.getColumn(1).getString();
    }
    return verdicts;
  });
}

void Store::RemoveOtherLogs(const std::vector<std::string>& paths) {
  Named(*database_, [&] {
    const std::set<std::string> kept(paths.begin(), paths.end());
    std::vector<std::string> gone;
    for (const auto& [path, digest] : DoneLogs()) {
      if (!kept.contains(path)) gone.push_back(path);
    }
    if (gone.empty()) return;
    SQLite::Transaction transaction(*database_);
    for (const std::string& path : gone) DeleteLog(path, database_.get());
    transaction.commit();
  });
}

void Store::ReplaceDives(const Tables& tables, const std::string& done) {
  Named(*database_, [&] {
    SQLite::Transaction transaction(*database_);
    for (const char* table : {"dive_fits", "predictions", "changes", "outliers"}) {
      database_->exec(fmt::format("DELETE FROM {}", table));
    }
    Insert(tables.dive_fits, database_.get());
    Insert(tables.predictions, database_.get());
    Insert(tables.changes, database_.get());
    Insert(tables.outliers, database_.get());
    SetDone(kDives, done, database_.get());
    transaction.commit();
  });
}

std::string Store::DoneDives() const {
  return Named(*database_, [&] {
    SQLite::Statement select(*database_, "SELECT digest FROM done WHERE name = ?");
    select.bind(1, kDives);
    return select.executeStep() ? select.getColumn(0).getString() : std::string();
  });
}

Tables Store::ReadTables() const {
  return Named(*database_, [&] {
    Tables tables;
    SelectInto(database_.get(), kByPath, &tables.logs);
    SelectInto(database_.get(), kByLog, &tables.fits);
    SelectInto(database_.get(), kAsWritten, &tables.dive_fits);
    SelectInto(database_.get(), kByLog, &tables.scores);
    tables.verdicts = SelectVerdicts(database_.get());
    SelectInto(database_.get(), kByLog, &tables.causes);
    SelectInto(database_.get(), kByLog, &tables.findings);
    SelectInto(database_.get(), kAsWritten, &tables.predictions);
    SelectInto(database_.get(), kAsWritten, &tables.changes);
    SelectInto(database_.get(), kAsWritten, &tables.outliers);
    return tables;
  });
}

Tables Store::ReadSummaryTables() const {
  return Named(*database_, [&] {
    Tables tables;
    SelectInto(database_.get(), kByPath, &tables.logs);
    SelectInto(database_.get(), kByLog, &tables.scores);
    tables.verdicts = SelectVerdicts(database_.get());
    SelectInto(database_.get(), kByLog, &tables.causes);
    SelectInto(database_.get(), kByLog, &tables.findings);
    SelectInto(database_.get(), kAsWritten, &tables.dive_fits);
    SelectInto(database_.get(), kAsWritten, &tables.changes);
    return tables;
  });
}

Tables ReadResults(const std::filesystem::path& file) { return Store(file).ReadTables(); }

Tables ReadSummary(const std::filesystem::path& file) { return Store(file).ReadSummaryTables(); }

void Store::LookInto(const std::filesystem::path& file) {
  try {
    others_.push_back(
        std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READONLY, 60000));
    RequireOurs(file, others_.back().get());
  } catch (const SQLite::Exception& error) {
    throw InputError(fmt::format("--merge={}: cannot be read: {}.", file.string(), error.what()));
  }
}

void Store::Merge(const std::filesystem::path& file) {
  try {
    {
      SQLite::Database other(file.string(), SQLite::OPEN_READONLY);
      RequireOurs(file, &other);
    }
    SQLite::Statement attach(*database_, "ATTACH ? AS other");
    attach.bind(1, file.string());
    attach.exec();
    {
      SQLite::Transaction transaction(*database_);
      // A run that did not come to its end, for lack of time say, gives way to one that did.
      database_->exec(
          fmt::format("DELETE FROM runs WHERE \"end\" <> {0} AND key IN "
                      "(SELECT key FROM other.runs WHERE \"end\" = {0})",
                      static_cast<int>(ChildEnd::kExited)));
      database_->exec("INSERT OR IGNORE INTO runs SELECT * FROM other.runs");
      database_->exec("INSERT OR IGNORE INTO files SELECT * FROM other.files");
      transaction.commit();
    }
    database_->exec("DETACH other");
  } catch (const SQLite::Exception& error) {
    throw InputError(fmt::format("--merge={}: cannot be read into {}: {}.",
                                 file.string(),
                                 database_->getFilename(),
                                 error.what()));
  }
}

}  // namespace fathom
