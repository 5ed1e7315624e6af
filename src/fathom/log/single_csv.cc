// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/single_csv.h"

#include <set>
#include <string>
#include <utility>

namespace fathom {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// The names in the first line, without blanks and quotes.
std::set<std::string> ColumnsOf(std::string_view text) {
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
  return columns;
}

}  // namespace

bool IsSingleCsvLog(std::string_view text) {
  const std::set<std::string> columns = ColumnsOf(text);
  return columns.contains("t") && columns.contains("tau") && columns.contains("v");
}

bool IsSingleCsvDecay(std::string_view text) {
  return ColumnsOf(text) == std::set<std::string>{"t", "v"};
}

bool IsMeantAsSingleCsvLog(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::set<std::string> columns;
  for (const std::string& column : ColumnsOf(text)) {
    columns.insert(column.substr(0, column.find_first_of("_[(")));
  }
  return columns.contains("t") + columns.contains("tau") + columns.contains("v") >= 2;
}

}  // namespace fathom
