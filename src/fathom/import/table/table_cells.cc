// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/table_cells.h"

#include "fathom/base/number.h"
#include "fathom/base/trimmed.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace fathom {
namespace {

constexpr std::array<std::string_view, 9> kNothing = {
    "", "nan", "-nan", "na", "n/a", "null", "none", "-", "--"};
constexpr std::size_t kLongestNumber = 64;  // characters

bool IsBlank(char c) { return c == ' ' || c == '\t'; }

std::string_view WithoutQuotes(std::string_view cell) {
  cell = Trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    cell = Trimmed(cell.substr(1, cell.size() - 2));
  }
  return cell;
}

}  // namespace

const std::vector<std::string_view>& CellSplitter::Split(std::string_view line) {
  cells_.clear();
  const bool is_blanks = separator_ == kBlanks;
  if (is_blanks) line = Trimmed(line);
  std::size_t begin = 0;
  bool is_quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size()) {
      if (line[i] == '"') is_quoted = !is_quoted;
      if (is_quoted || !(is_blanks ? IsBlank(line[i]) : line[i] == separator_)) continue;
    }
    cells_.push_back(WithoutQuotes(line.substr(begin, i - begin)));
    begin = i + 1;
    while (is_blanks && begin < line.size() && IsBlank(line[begin])) ++begin;
    if (is_blanks && i < line.size()) i = begin - 1;
  }
  return cells_;
}

std::optional<double> ParseCell(std::string_view cell, char decimal) {
  if (cell.starts_with('+')) cell.remove_prefix(1);
  if (decimal == '.') return ParseFiniteNumber(cell);
  if (cell.size() > kLongestNumber || cell.find('.') != std::string_view::npos) return std::nullopt;
  std::array<char, kLongestNumber> text = {};
  std::copy(cell.begin(), cell.end(), text.begin());
  std::replace(text.begin(), text.end(), decimal, '.');
  return ParseFiniteNumber({text.data(), cell.size()});
}

bool IsEmptyCell(std::string_view cell) {
  if (cell.size() > 4) return false;
  std::array<char, 4> lower = {};
  std::transform(cell.begin(), cell.end(), lower.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return std::find(kNothing.begin(), kNothing.end(), std::string_view(lower.data(), cell.size())) !=
         kNothing.end();
}

}  // namespace fathom
