// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/single_csv.h"

#include <set>
#include <string>
#include <utility>

namespace fathom {

bool IsSingleCsvLog(std::string_view text) {
  const std::string line(text.substr(0, text.find_first_of("\r\n")));
  std::set<std::string> columns;
  std::string column;
  for (const char c : line + ",") {
    if (c == ',') {
      columns.insert(std::exchange(column, ""));
    } else if (c != ' ' && c != '"') {
      column += c;
    }
  }
  return columns.contains("t") && columns.contains("tau") && columns.contains("v");
}

}  // namespace fathom
