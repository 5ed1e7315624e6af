// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "batch_results.h"

#include <algorithm>

#include <SQLiteCpp/SQLiteCpp.h>

namespace fathom {
namespace {

// All columns that a table has, but for those that no two runs share.
std::vector<std::string> ColumnsOf(const std::string& table, SQLite::Database* database) {
  SQLite::Statement info(*database, "PRAGMA table_info(" + table + ")");
  std::vector<std::string> columns;
  while (info.executeStep()) {
    const std::string name = info.getColumn(1).getString();
    if (name != "seconds" && name != "peak_mb") columns.push_back(name);
  }
  return columns;
}

std::vector<std::string> RowsOf(SQLite::Statement* select) {
  std::vector<std::string> rows;
  while (select->executeStep()) {
    std::string row;
    for (int i = 0; i < select->getColumnCount(); ++i) {
      const SQLite::Column column = select->getColumn(i);
      row += (i > 0 ? "|" : "") + (column.isNull() ? std::string("NULL") : column.getString());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void AddRows(const std::string& table,
             const std::string& where,
             const std::string& log,
             SQLite::Database* database,
             std::vector<std::string>* rows) {
  std::string columns;
  for (const std::string& column : ColumnsOf(table, database)) {
    columns += (columns.empty() ? "\"" : ", \"") + column + "\"";
  }
  SQLite::Statement select(*database, "SELECT " + columns + " FROM " + table + where);
  if (!where.empty()) select.bind(1, log);
  for (const std::string& row : RowsOf(&select)) rows->push_back(table + "|" + row);
}

}  // namespace

std::vector<std::string> PublicRows(const std::filesystem::path& results) {
  SQLite::Database database(results.string(), SQLite::OPEN_READWRITE);
  std::vector<std::string> rows;
  for (const char* table : {"logs",
                            "fits",
                            "dive_fits",
                            "scores",
                            "verdicts",
                            "causes",
                            "findings",
                            "predictions",
                            "changes",
                            "outliers"}) {
    AddRows(table, "", "", &database, &rows);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<std::string> PublicRowsOf(const std::string& log,
                                      const std::filesystem::path& results) {
  SQLite::Database database(results.string(), SQLite::OPEN_READWRITE);
  std::vector<std::string> rows;
  AddRows("logs", " WHERE path = ?", log, &database, &rows);
  for (const char* table : {"fits", "scores", "verdicts", "causes", "findings"}) {
    AddRows(table, " WHERE log = ?", log, &database, &rows);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<std::string> Query(const std::string& sql, const std::filesystem::path& results) {
  SQLite::Database database(results.string(), SQLite::OPEN_READWRITE);
  SQLite::Statement select(database, sql);
  return RowsOf(&select);
}

std::map<std::string, std::string> StatesOf(const std::filesystem::path& results) {
  SQLite::Database database(results.string(), SQLite::OPEN_READWRITE);
  SQLite::Statement select(database, "SELECT path, status || ': ' || message FROM logs");
  std::map<std::string, std::string> states;
  while (select.executeStep()) {
    states[select.getColumn(0).getString()] = select.getColumn(1).getString();
  }
  return states;
}

}  // namespace fathom
