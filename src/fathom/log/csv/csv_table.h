// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fathom {

// Which columns a CSV file must and may have beside "t".
struct CsvSpec {
  std::vector<std::string> required;         // every one of them
  std::vector<std::string> at_least_one_of;  // any subset but none; empty: no such rule
  std::string numbered;                      // "thruster_": thruster_1, ... count among these too
  std::vector<std::string> named = {};  // "fin_": so do fin_rudder and any other name behind it

  // True: stamps may stand in several rows (one row per tag), but never go back.
  bool allow_equal_stamps = false;
};

// A CSV file of finite numbers over stamps.
struct CsvTable {
  std::string name;                   // of the file, as in messages
  Stream stream;                      // the columns that the spec names, in the order of the file
  std::vector<int> line_of_row;       // counted from 1
  std::vector<std::string> not_read;  // the other columns

  // "velocity.csv: 2 further columns are not read: du, dv." Empty if every column was read.
  std::string Remark() const;
};

// Reads a CSV file: a line of column names, then at least two rows of numbers;
// docs/file_formats.md. Throws InputError, naming file, line and column, for whatever breaks the
// format, and for a column whose name is a known one with a unit behind it ("u_cms").
CsvTable ReadCsvTable(const std::filesystem::path& path, const CsvSpec& spec);

// The same from memory; `name` stands for the file in messages.
CsvTable ParseCsvTable(const std::string& name, const std::string& text, const CsvSpec& spec);

}  // namespace fathom
