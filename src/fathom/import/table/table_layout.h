// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/recording.h"
#include "fathom/import/table/table_cells.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What a user says of a table; what is left out is found from the first lines.
struct TableOptions {
  std::optional<char> separator;   // ',', ';', '\t', '|', or kBlanks
  std::optional<char> decimal;     // '.' or ','
  std::optional<int> header_line;  // the line of the column names, from 1; 0: there is none
  std::string time;                // the column of the stamps, by name or number
  std::string time_unit;           // of a column of numbers
};

// How a table of text is laid out.
struct TableLayout {
  CellStyle style;
  std::vector<Field> columns;   // "1", "2", ... where the file names none
  std::uint64_t first_row = 0;  // where the rows begin [bytes]
  std::int64_t first_row_line = 1;
  std::string remark;  // on names that do not fit; may be empty
};

// Finds the layout from the first lines of a file: the separator and decimal sign that make the
// most numbers of them, the rows behind the last line that is none, and the names and units above
// them. A unit may stand in brackets behind a name, "u [cm/s]", or in a line of its own. Throws
// InputError, naming the file, if no lines are rows of at least two cells.
TableLayout FindTableLayout(ByteFile* file, const TableOptions& options);

// "u [cm/s]" is {"u", "cm/s"}; also with round brackets. Without brackets the unit is empty.
Field FieldOfHeader(std::string_view text);

}  // namespace fathom
