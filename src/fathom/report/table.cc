// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/table.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <glog/logging.h>

namespace fathom {
namespace {

// Characters, not bytes: every byte of UTF-8 but those that continue a character.
std::size_t Width(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

std::string PadLeft(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, Width(text)), ' ') + text;
}

std::string PadRight(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, Width(text)), ' ');
}

// A line break or a tab inside a cell would tear the table apart.
std::string OnOneLine(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return text;
}

// Cells of a column of numbers, all as wide as the widest, the ± below each other.
void AlignNumbers(std::vector<std::string>& cells) {
  std::size_t value_width = 0;
  std::size_t std_width = 0;
  for (const std::string& cell : cells) {
    const std::size_t at = cell.find(kPlusMinus);
    value_width = std::max(value_width, Width(cell.substr(0, at)));
    if (at == std::string::npos) continue;
    std_width = std::max(std_width, Width(cell.substr(at + kPlusMinus.size())));
  }
  for (std::string& cell : cells) {
    const std::size_t at = cell.find(kPlusMinus);
    std::string text = PadLeft(cell.substr(0, at), value_width);
    if (at != std::string::npos) {
      text += std::string(kPlusMinus) + PadLeft(cell.substr(at + kPlusMinus.size()), std_width);
    } else if (std_width > 0) {
      text += std::string(Width(kPlusMinus) + std_width, ' ');
    }
    cell = text;
  }
}

std::string WithoutSpacesAtTheEnd(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string_view Mark(RowFlag flag) {
  switch (flag) {
    case RowFlag::kBest:
    case RowFlag::kKept:
      return "* ";
    case RowFlag::kUnusable:
      return "! ";
    case RowFlag::kNone:
      break;
  }
  return "  ";
}

// The last of the columns of the highest rank above 0; the number of columns if there is none.
std::size_t HighestRank(const std::vector<TableColumn>& columns) {
  std::size_t highest = columns.size();
  int rank = 1;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].rank < rank) continue;
    rank = columns[i].rank;
    highest = i;
  }
  return highest;
}

void DropColumn(std::size_t column, Table* table) {
  const auto at = static_cast<std::ptrdiff_t>(column);
  table->columns.erase(table->columns.begin() + at);
  for (TableRow& row : table->rows) row.cells.erase(row.cells.begin() + at);
}

// Of the widest line.
std::size_t WidthOf(const Table& table) {
  std::istringstream lines(FormatTable(table));
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, Width(line));
  return widest;
}

}  // namespace

std::string FormatTable(const Table& table) {
  for (const TableRow& row : table.rows) CHECK_EQ(row.cells.size(), table.columns.size());
  const bool has_marks = std::ranges::any_of(
      table.rows, [](const TableRow& row) { return row.flag != RowFlag::kNone; });

  std::string heading = has_marks ? "  " : "";
  std::string rule = heading;
  std::vector<std::string> lines;
  for (const TableRow& row : table.rows) lines.emplace_back(has_marks ? Mark(row.flag) : "");

  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const TableColumn& column = table.columns[i];
    const std::string title = OnOneLine(column.heading);
    std::vector<std::string> cells;
    for (const TableRow& row : table.rows) cells.push_back(OnOneLine(row.cells[i]));
    if (column.is_number) AlignNumbers(cells);
    std::size_t width = Width(title);
    for (const std::string& cell : cells) width = std::max(width, Width(cell));

    const std::string gap = i == 0 ? "" : "  ";
    const auto pad = column.is_number ? PadLeft : PadRight;
    heading += gap + pad(title, width);
    rule += gap + std::string(width, '-');
    for (std::size_t row = 0; row < lines.size(); ++row) lines[row] += gap + pad(cells[row], width);
  }

  std::string text;
  if (!table.caption.empty()) text += OnOneLine(table.caption) + "\n";
  text += WithoutSpacesAtTheEnd(heading) + "\n" + rule + "\n";
  for (const std::string& line : lines) text += WithoutSpacesAtTheEnd(line) + "\n";
  return text;
}

Table Narrowed(Table table, std::size_t width, std::vector<std::string>* left_out) {
  std::vector<std::string> headings;
  for (const TableColumn& column : table.columns) headings.push_back(column.heading);
  std::vector<bool> is_shown(headings.size(), true);
  std::vector<std::size_t> places(headings.size());  // of the columns that are left
  std::iota(places.begin(), places.end(), std::size_t{0});
  while (WidthOf(table) > width) {
    const std::size_t dropped = HighestRank(table.columns);
    if (dropped == table.columns.size()) break;
    is_shown[places[dropped]] = false;
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(dropped));
    DropColumn(dropped, &table);
  }
  for (std::size_t i = 0; left_out != nullptr && i < headings.size(); ++i) {
    if (!is_shown[i]) left_out->push_back(headings[i]);
  }
  return table;
}

}  // namespace fathom
