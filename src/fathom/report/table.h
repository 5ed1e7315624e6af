// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Between a value and its standard deviation in a cell.
inline constexpr std::string_view kPlusMinus = " ± ";

enum class RowFlag { kNone, kBest, kKept, kUnusable };

struct TableColumn {
  std::string heading;
  bool is_number = false;  // aligned at the "±" where there is one, otherwise at the right
  int rank = 0;            // 0: always shown; where room lacks, the highest is left out first
};

struct TableRow {
  std::vector<std::string> cells;  // one for each column
  RowFlag flag = RowFlag::kNone;
};

struct Table {
  std::string caption;  // may be empty
  std::vector<TableColumn> columns;
  std::vector<TableRow> rows;

  // On a page: the words to click on. Such a table is closed until asked for and is not printed.
  std::string fold = {};
};

// The table for a terminal: two spaces between the columns, a line below the headings, "* " before
// a best or kept row and "! " before an unusable one where there is such a row. UTF-8; a character
// counts as one column wide. Ends with a newline.
//
//     DOF    family        inertia [kg]
//     -----  ------------  ------------
//   * surge  output_error   890.3 ± 4.2
//   ! surge  adaptive           -
std::string FormatTable(const Table& table);

// How a table becomes text: FormatTable(), or something narrower.
using TableFormat = std::string (*)(const Table&);

// The table without the columns that FormatTable() has no room for in this width: those of the
// highest rank first, of one rank the last. Wider than that if all that is left has rank 0.
// `left_out`: their headings, from left to right; may be null.
Table Narrowed(Table table, std::size_t width, std::vector<std::string>* left_out = nullptr);

}  // namespace fathom
