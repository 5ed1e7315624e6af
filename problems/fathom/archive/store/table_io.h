// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/store/row_columns.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>

namespace fathom {

// Rows of the tables to and from SQLite, by VisitColumns(). NaN is NULL.

// Binds the values of a row one after the other.
class Binder {
 public:
  explicit Binder(SQLite::Statement* statement) : statement_(statement) {}

  void operator()(const char*, const std::string& text) { statement_->bind(++index_, text); }
  void operator()(const char*, double number) {
    if (std::isfinite(number)) {
      statement_->bind(++index_, number);
    } else {
      statement_->bind(++index_);
    }
  }
  void operator()(const char*, int number) { statement_->bind(++index_, number); }
  void operator()(const char*, bool flag) { statement_->bind(++index_, flag ? 1 : 0); }

 private:
  SQLite::Statement* statement_;
  int index_ = 0;
};

// Reads the values of a row one after the other.
class Reader {
 public:
  explicit Reader(const SQLite::Statement& statement) : statement_(statement) {}

  void operator()(const char*, std::string& text) {
    const SQLite::Column column = Next();
    text = column.isNull() ? "" : column.getString();
  }
  void operator()(const char*, double& number) {
    const SQLite::Column column = Next();
    number = column.isNull() ? kNoNumber : column.getDouble();
  }
  void operator()(const char*, int& number) { number = Next().getInt(); }
  void operator()(const char*, bool& flag) { flag = Next().getInt() != 0; }

 private:
  SQLite::Column Next() { return const_cast<SQLite::Statement&>(statement_).getColumn(index_++); }

  const SQLite::Statement& statement_;
  int index_ = 0;
};

struct ColumnLister {
  std::string names, declarations;

  void operator()(const char* name, const std::string&) { Add(name, "TEXT"); }
  void operator()(const char* name, double) { Add(name, "REAL"); }
  void operator()(const char* name, int) { Add(name, "INTEGER"); }
  void operator()(const char* name, bool) { Add(name, "INTEGER"); }
  void Add(const char* name, const char* type) {
    if (!names.empty()) names += ", ", declarations += ", ";
    const std::string quoted = std::string("\"") + name + "\"";
    names += quoted;
    declarations += quoted + " " + type;
  }
};

template <typename Row>
ColumnLister ColumnsOf() {
  ColumnLister columns;
  Row row;
  VisitColumns(row, columns);
  return columns;
}

template <typename Row>
void CreateTable(SQLite::Database* database) {
  database->exec("CREATE TABLE IF NOT EXISTS " + std::string(TableName<Row>()) + "(" +
                 ColumnsOf<Row>().declarations + ")");
}

template <typename Row>
void Insert(const std::vector<Row>& rows, SQLite::Database* database) {
  if (rows.empty()) return;
  const std::string names = ColumnsOf<Row>().names;
  std::string marks = "?";
  for (const char c : names) marks += c == ',' ? ", ?" : "";
  SQLite::Statement insert(
      *database,
      "INSERT INTO " + std::string(TableName<Row>()) + "(" + names + ") VALUES(" + marks + ")");
  for (Row row : rows) {
    Binder bind(&insert);
    VisitColumns(row, bind);
    insert.exec();
    insert.reset();
  }
}

template <typename Row>
std::vector<Row> Select(SQLite::Database* database, const std::string& names, const char* order) {
  SQLite::Statement select(
      *database,
      "SELECT " + names + " FROM " + std::string(TableName<Row>()) + " ORDER BY " + order);
  std::vector<Row> rows;
  while (select.executeStep()) {
    Reader read(select);
    Row row;
    VisitColumns(row, read);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace fathom
