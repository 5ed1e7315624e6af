// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/csv/csv_rows.h"

#include "fathom/base/input_error.h"
#include "fathom/base/trimmed.h"
#include "fathom/log/csv/refuse_utf16.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <new>
#include <string_view>

#include <csv.h>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kLongestLine = 65536;  // [bytes]

int LineOf(std::string_view text, std::size_t position) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + position, '\n'));
}

void RefuseNulBytes(const std::string& name, std::string_view text) {
  const std::size_t first = text.find('\0');
  if (first == std::string_view::npos) return;
  const int line = LineOf(text, first);
  const auto count = std::count(text.begin(), text.end(), '\0');
  const std::string file = std::filesystem::path(name).filename().string();
  if (text.find_first_not_of('\0', first) == std::string_view::npos) {
    throw InputError(fmt::format(
        "{}:{}: {} NUL bytes from this line to the end of the file, expected text. A power cut "
        "leaves "
        "such a tail. Cut it off (tr -d '\\0' < {} > cut.csv) and remove the last row if it is "
        "incomplete.",
        name,
        line,
        count,
        file));
  }
  throw InputError(
      fmt::format("{}:{}: a NUL byte amid the text ({} in the file), expected text. The file is "
                  "corrupt or not a CSV file; restore it from its source.",
                  name,
                  line,
                  count));
}

// dos2unix mends CR LF and leaves a carriage return alone, the line end of old Macs, as it is.
void RefuseCarriageReturns(const std::string& name, std::string_view text) {
  const std::size_t at = text.find('\r');
  if (at == std::string_view::npos) return;
  const bool is_alone = !text.substr(at + 1).starts_with('\n');
  throw InputError(fmt::format(
      "{}:{}: the line ends in a carriage return, expected a line feed only. Convert the file {}.",
      name,
      LineOf(text, at),
      is_alone ? fmt::format("(tr '\\r' '\\n' < {} > converted.csv)",
                             std::filesystem::path(name).filename().string())
               : "with dos2unix"));
}

void RefuseWhatIsNoPlainText(const std::string& name, std::string_view text) {
  if (text.empty()) {
    throw InputError(name + ": is empty, expected a line of column names and rows of numbers.");
  }
  if (text.starts_with("\xef\xbb\xbf")) {
    throw InputError(fmt::format(
        "{0}:1: starts with a UTF-8 byte order mark, expected the first column name. Strip "
        "it (sed -i '1s/^\\xEF\\xBB\\xBF//' {1}).",
        name,
        std::filesystem::path(name).filename().string()));
  }
  RefuseUtf16(name, text);
  RefuseNulBytes(name, text);
  RefuseCarriageReturns(name, text);
}

// The cells of a line without quotes; none if it is blank.
void SplitPlainLine(std::string_view line, std::vector<std::string_view>* cells) {
  cells->clear();
  if (Trimmed(line).empty()) return;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells->push_back(Trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
}

void TakeCell(void* text, std::size_t length, void* cells) {
  static_cast<std::vector<std::string>*>(cells)->emplace_back(static_cast<const char*>(text),
                                                              length);
}

// The cells of a line that holds quotes; `place` names the line in messages.
std::vector<std::string> CellsOfQuotedLine(const std::string& place, std::string_view line) {
  csv_parser parser;
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
  const std::unique_ptr<csv_parser, void (*)(csv_parser*)> guard(&parser, csv_free);
  std::vector<std::string> cells;
  if (csv_parse(&parser, line.data(), line.size(), TakeCell, nullptr, &cells) != line.size()) {
    throw InputError(place +
                     "a quote (\") stands inside a cell, expected it around the whole cell.");
  }
  if (csv_fini(&parser, TakeCell, nullptr, &cells) != 0) {
    throw InputError(place + "a quote (\") is opened and not closed on this line.");
  }
  return cells;
}

}  // namespace

void ForEachCsvRow(
    const std::string& name,
    const std::string& text,
    const std::function<void(int line, const std::vector<std::string_view>& cells)>& take_row) {
  RefuseWhatIsNoPlainText(name, text);
  const std::string_view all = text;
  std::vector<std::string_view> cells;
  std::vector<std::string> unquoted;
  int line = 1;
  for (std::size_t begin = 0; begin < all.size(); ++line) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    const std::string_view row = all.substr(begin, end - begin);
    if (row.size() > kLongestLine) {
      throw InputError(
          fmt::format("{}:{}: the line has {} bytes, expected at most {}. Is this CSV?",
                      name,
                      line,
                      row.size(),
                      kLongestLine));
    }
    if (row.find('"') == std::string_view::npos) {
      SplitPlainLine(row, &cells);
    } else {
      unquoted = CellsOfQuotedLine(fmt::format("{}:{}: ", name, line), row);
      cells.assign(unquoted.begin(), unquoted.end());
    }
    if (cells.empty()) {
      throw InputError(
          fmt::format("{}:{}: the line is empty, expected a row. Remove the line.", name, line));
    }
    take_row(line, cells);
    begin = end + 1;
  }
}

}  // namespace fathom
