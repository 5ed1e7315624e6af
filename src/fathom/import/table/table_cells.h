// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

inline constexpr char kBlanks = ' ';  // a separator that stands for any run of blanks and tabs

// How the cells of a table are written.
struct CellStyle {
  char separator = ',';
  char decimal = '.';
};

// Splits lines into cells.
class CellSplitter {
 public:
  explicit CellSplitter(char separator) : separator_(separator) {}

  // The cells without blanks and quotes around them; they last until the next call, as far as
  // `line` does. A quote that is not closed ends with the line.
  const std::vector<std::string_view>& Split(std::string_view line);

 private:
  char separator_;
  std::vector<std::string_view> cells_;
};

// The finite number of a cell. Nothing for an empty cell, "nan", and anything else.
std::optional<double> ParseCell(std::string_view cell, char decimal);

// An empty cell, or one of the words for nothing: "nan", "NaN", "NA", "null", "-", "None".
bool IsEmptyCell(std::string_view cell);

}  // namespace fathom
