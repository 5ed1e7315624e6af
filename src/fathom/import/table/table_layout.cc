// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/table_layout.h"

#include "fathom/base/input_error.h"
#include "fathom/import/table/stamp_text.h"
#include "fathom/import/table/text_lines.h"
#include "fathom/import/units/unit.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kLinesLookedAt = 400;
constexpr int kRowsToBeSure = 3;  // as many lines alike are rows, or all to the end of the file
constexpr std::array<char, 5> kSeparators = {',', ';', '\t', '|', kBlanks};

struct Line {
  std::string text;
  std::int64_t number;
  std::uint64_t offset;
};

// The lines that are not empty.
std::vector<Line> FirstLines(ByteFile* file) {
  std::vector<Line> first;
  TextLines lines(file);
  lines.JoinQuoted();
  while (std::ssize(first) < kLinesLookedAt && lines.Next()) {
    if (lines.text().find_first_not_of(" \t") == std::string_view::npos) continue;
    // A last line without an end may be cut.
    if (!lines.has_end() && std::ssize(first) > kRowsToBeSure) break;
    first.push_back({std::string(lines.text()), lines.number(), lines.offset()});
  }
  return first;
}

enum class Cell { kValue, kEmpty, kText };

Cell KindOf(std::string_view cell, char decimal) {
  if (IsEmptyCell(cell)) return Cell::kEmpty;
  return ParseCell(cell, decimal) || ParseTextStamp(cell) ? Cell::kValue : Cell::kText;
}

// What a line is under a style.
struct Row {
  std::size_t num_cells = 0;
  std::size_t num_values = 0;
  std::size_t num_texts = 0;

  // At least two cells, a number among them, and no more words than numbers.
  bool IsRow() const { return num_cells >= 2 && num_values >= std::max<std::size_t>(1, num_texts); }
};

Row RowOf(const Line& line, CellStyle style, CellSplitter* splitter) {
  Row row;
  for (const std::string_view cell : splitter->Split(line.text)) {
    const Cell kind = KindOf(cell, style.decimal);
    ++row.num_cells;
    row.num_values += kind == Cell::kValue ? 1 : 0;
    row.num_texts += kind == Cell::kText ? 1 : 0;
  }
  return row;
}

// The lines as rows under a style.
struct Reading {
  CellStyle style;
  std::ptrdiff_t first_row = -1;  // index of the line; -1: none is a row
  std::size_t num_cells = 0;      // of each row
  double num_values = 0.0;        // mean of the rows
  double value_share = 0.0;       // of the cells of the rows, the empty ones not counted
};

// The first line from which on some lines alike are rows.
Reading ReadAs(CellStyle style, const std::vector<Line>& lines) {
  CellSplitter splitter(style.separator);
  std::vector<Row> rows;
  for (const Line& line : lines) rows.push_back(RowOf(line, style, &splitter));
  Reading reading = {style};
  for (std::ptrdiff_t i = 0; i < std::ssize(rows); ++i) {
    const std::ptrdiff_t end = std::min<std::ptrdiff_t>(std::ssize(rows), i + kRowsToBeSure);
    const bool are_rows = std::all_of(rows.begin() + i, rows.begin() + end, [&](const Row& row) {
      return row.IsRow() && row.num_cells == rows[i].num_cells;
    });
    if (!are_rows) continue;
    reading.first_row = i;
    reading.num_cells = rows[i].num_cells;
    double num_values = 0.0;
    double num_texts = 0.0;
    for (std::ptrdiff_t k = i; k < std::ssize(rows); ++k) {
      num_values += static_cast<double>(rows[k].num_values);
      num_texts += static_cast<double>(rows[k].num_texts);
    }
    reading.num_values = num_values / static_cast<double>(std::ssize(rows) - i);
    reading.value_share = num_values / (num_values + num_texts);
    return reading;
  }
  return reading;
}

// Whether `a` reads the lines better than `b`.
bool IsBetter(const Reading& a, const Reading& b) {
  if ((a.first_row < 0) != (b.first_row < 0)) return b.first_row < 0;
  if (a.value_share != b.value_share) return a.value_share > b.value_share;
  return a.num_values > b.num_values;
}

std::string_view WithoutCommentSign(std::string_view line) {
  const std::size_t first = line.find_first_not_of("#% \t/");
  return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

// The cells of a line above the rows; none if they are not as many as theirs.
std::vector<std::string> HeaderCells(const Line& line, const Reading& reading) {
  CellSplitter splitter(reading.style.separator);
  for (const std::string_view text : {std::string_view(line.text), WithoutCommentSign(line.text)}) {
    const auto& split = splitter.Split(text);
    std::vector<std::string> cells(split.begin(), split.end());
    // Rows may end in a separator that the names do not end in.
    if (cells.size() + 1 == reading.num_cells) cells.emplace_back();
    if (cells.size() == reading.num_cells && text == WithoutCommentSign(text)) return cells;
  }
  return {};
}

std::string_view WithoutBrackets(std::string_view text) {
  if (text.size() >= 2 && ((text.front() == '[' && text.back() == ']') ||
                           (text.front() == '(' && text.back() == ')'))) {
    return text.substr(1, text.size() - 2);
  }
  return text;
}

// A line of units: each cell is one, or nothing, and not all are nothing.
bool AreUnits(const std::vector<std::string>& cells) {
  bool has_unit = false;
  for (const std::string& cell : cells) {
    const std::string_view unit = WithoutBrackets(cell);
    if (IsEmptyCell(unit)) continue;
    if (unit.size() == cell.size() && !FindUnit(unit)) return false;
    has_unit = true;
  }
  return has_unit;
}

std::vector<Field> Numbered(std::size_t num_columns) {
  std::vector<Field> columns;
  for (std::size_t i = 1; i <= num_columns; ++i) {
    columns.push_back({std::to_string(i), "", static_cast<int>(i)});
  }
  return columns;
}

// From the lines above the rows; `line`: the index of that of the names where a user says so.
std::vector<Field> FindColumns(const std::vector<Line>& lines,
                               const Reading& reading,
                               std::optional<std::ptrdiff_t> line) {
  std::vector<Field> columns = Numbered(reading.num_cells);
  const std::ptrdiff_t last = reading.first_row - 1;
  if (last < 0 || (line && *line < 0)) return columns;
  std::vector<std::string> names = HeaderCells(lines[line.value_or(last)], reading);
  std::vector<std::string> units;
  if (!line && last > 0 && AreUnits(names)) {
    std::vector<std::string> above = HeaderCells(lines[last - 1], reading);
    if (!above.empty()) {
      units = std::move(names);
      names = std::move(above);
    }
  } else if (line && *line + 1 == last) {
    units = HeaderCells(lines[last], reading);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Field field = FieldOfHeader(names[i]);
    if (!field.name.empty()) {
      columns[i].name = field.name;
      columns[i].unit = field.unit;
    }
    if (i < units.size() && columns[i].unit.empty() && !IsEmptyCell(WithoutBrackets(units[i]))) {
      columns[i].unit = WithoutBrackets(units[i]);
    }
  }
  return columns;
}

// On names above the rows that are more or fewer than their cells; empty where there are none.
std::string OnNamesOfAnotherNumber(const std::vector<Line>& lines, const Reading& reading) {
  const std::ptrdiff_t last = reading.first_row - 1;
  if (last < 0 || !HeaderCells(lines[last], reading).empty()) return {};
  CellSplitter splitter(reading.style.separator);
  const auto& names = splitter.Split(WithoutCommentSign(lines[last].text));
  const bool are_names =
      names.size() > 1 && std::none_of(names.begin(), names.end(), [&](std::string_view name) {
        return KindOf(name, reading.style.decimal) == Cell::kValue;
      });
  if (!are_names) return {};
  return fmt::format(
      "line {} has {} names, the rows {} cells: which name is whose is not known, and the columns "
      "are "
      "called 1 to {}. Mend that line, or name columns by their numbers.",
      lines[last].number,
      names.size(),
      reading.num_cells,
      reading.num_cells);
}

// Two columns of one name cannot be told apart: the later ones get their number.
void MakeUnique(std::vector<Field>* columns) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < columns->size(); ++i) {
    std::string& name = (*columns)[i].name;
    if (taken.contains(name)) name += fmt::format("#{}", i + 1);
    taken.insert(name);
  }
}

}  // namespace

Field FieldOfHeader(std::string_view text) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
    const std::size_t at = text.rfind(open);
    if (at == std::string_view::npos || !text.ends_with(close)) continue;
    std::string_view name = text.substr(0, at);
    while (name.ends_with(' ') || name.ends_with('_')) name.remove_suffix(1);
    return {std::string(name), std::string(text.substr(at + 1, text.size() - at - 2))};
  }
  return {std::string(text), ""};
}

TableLayout FindTableLayout(ByteFile* file, const TableOptions& options) {
  const std::vector<Line> lines = FirstLines(file);
  Reading best;
  for (const char separator : kSeparators) {
    if (options.separator && *options.separator != separator) continue;
    for (const char decimal : {'.', ','}) {
      if (options.decimal ? *options.decimal != decimal : decimal == separator) continue;
      const Reading reading = ReadAs({separator, decimal}, lines);
      if (IsBetter(reading, best)) best = reading;
    }
  }
  if (best.first_row < 0) {
    throw InputError(fmt::format(
        "{}: the first {} lines hold no rows of numbers, expected a table of at least two columns. "
        "Its separator may be none of , ; tab | and blanks.",
        file->path().string(),
        lines.size()));
  }
  std::optional<std::ptrdiff_t> header;
  if (options.header_line) {
    header = std::find_if(lines.begin(),
                          lines.end(),
                          [&](const Line& line) { return line.number == *options.header_line; }) -
             lines.begin();
    if (*options.header_line == 0) {
      header = -1;
    } else if (*header >= best.first_row) {
      throw InputError(
          fmt::format("{}: the rows begin on line {}, expected 'header_line' above it "
                      "and not empty. It is {}.",
                      file->path().string(),
                      lines[best.first_row].number,
                      *options.header_line));
    }
  }
  TableLayout layout;
  layout.style = best.style;
  layout.columns = FindColumns(lines, best, header);
  MakeUnique(&layout.columns);
  if (!header) layout.remark = OnNamesOfAnotherNumber(lines, best);
  layout.first_row = lines[best.first_row].offset;
  layout.first_row_line = lines[best.first_row].number;
  return layout;
}

}  // namespace fathom
