// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/table/table_layout.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Where the stamps of a table stand and how they are written.
struct StampRule {
  int column = -1;           // -1: the table has no stamps
  int date_column = -1;      // of the day, where `column` holds the time of day
  bool is_text = false;      // a date or a time of day, otherwise a number
  double factor = 1.0;       // seconds to one of that number
  bool is_utc = false;       // seconds since 1970
  bool counts_rows = false;  // a first column 0, 1, 2, ... for want of any other
  std::string remark;        // what was guessed; may be empty
};

// Finds the stamps by the options, or by the columns' names ("t", "Time [ms]", "TimeUS", "date"),
// or by a word of a name ("original_timestamp") whose numbers grow, or as dates, or as a
// first column that only grows. One that counts rows goes behind any other that only grows. A unit
// that nobody states is guessed from the size of the numbers: nobody dives before 1973. `rows`: the
// cells of some first rows. Throws InputError, naming `file`, for an option that does not fit.
StampRule FindStamps(const std::string& file,
                     const TableLayout& layout,
                     const TableOptions& options,
                     const std::vector<std::vector<std::string>>& rows);

// The index of the column of this name, also with its unit behind it as in the file, or of this
// number; -1 if there is none.
int FindColumn(const std::vector<Field>& columns, std::string_view name);

// Turns the cells of one row after the other into stamps.
class StampReader {
 public:
  StampReader(StampRule rule, char decimal) : rule_(std::move(rule)), decimal_(decimal) {}

  // [s]; nothing where the cell holds no stamp. Times of day go on behind midnight.
  std::optional<double> Read(const std::vector<std::string_view>& cells);

 private:
  StampRule rule_;
  char decimal_;
  double midnight_ = 0.0;  // [s] since the first
  std::optional<double> last_;
};

}  // namespace fathom
