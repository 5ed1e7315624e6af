// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/table_stamps.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/import/table/stamp_text.h"
#include "fathom/import/units/unit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kDay = 86400.0;  // [s]

// Names of a column of stamps without their unit, in lower case, the surest first.
constexpr std::array<std::string_view, 17> kNames = {"t",
                                                     "time",
                                                     "timestamp",
                                                     "stamp",
                                                     "timestamps",
                                                     "datetime",
                                                     "date_time",
                                                     "zeit",
                                                     "epoch",
                                                     "unixtime",
                                                     "utc",
                                                     "elapsed",
                                                     "elapsed_time",
                                                     "rosbagtimestamp",
                                                     "sec",
                                                     "seconds",
                                                     "date"};

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// The unit at the end of a name: "time_ms", "TimeUS", "t [ms]" (whose unit is stated).
std::pair<std::string, std::string> NameAndUnit(const Field& column) {
  std::string name = LowerCase(column.name);
  if (!column.unit.empty()) return {name, column.unit};
  for (const std::string_view unit : {"us", "ms", "ns", "sec", "s"}) {
    for (const std::string_view sign : {"_", " ", "-", ""}) {
      const std::string ending = std::string(sign) + std::string(unit);
      if (!name.ends_with(ending)) continue;
      const std::string stem = name.substr(0, name.size() - ending.size());
      const bool is_sure = !sign.empty() || stem == "time";
      if (is_sure && std::find(kNames.begin(), kNames.end(), stem) != kNames.end()) {
        return {stem, std::string(unit)};
      }
    }
  }
  return {name, ""};
}

std::string_view Cell(const std::vector<std::string>& row, int column) {
  return column < std::ssize(row) ? std::string_view(row[column]) : std::string_view();
}

// The first cell of a column that holds anything.
std::string_view FirstCell(const std::vector<std::vector<std::string>>& rows, int column) {
  for (const auto& row : rows) {
    if (!IsEmptyCell(Cell(row, column))) return Cell(row, column);
  }
  return {};
}

bool OnlyGrows(const std::vector<std::vector<std::string>>& rows, int column, char decimal) {
  double last = -INFINITY;
  for (const auto& row : rows) {
    const auto number = ParseCell(Cell(row, column), decimal);
    if (!number || *number <= last) return false;
    last = *number;
  }
  return rows.size() >= 2;
}

// By name; -1 if none is called so.
int FindByName(const std::vector<Field>& columns) {
  auto surest = kNames.end();
  int found = -1;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto at = std::find(kNames.begin(), surest, NameAndUnit(columns[i]).first);
    if (at == surest) continue;
    surest = at;
    found = static_cast<int>(i);
  }
  return found;
}

// The words of a name, in lower case: "original", "time", "stamp" of "original_timeStamp".
std::vector<std::string> WordsOf(std::string_view name) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool begins =
        std::isupper(c) != 0 && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
    if (std::isalnum(c) == 0 || begins) words.emplace_back();
    if (std::isalnum(c) != 0) words.back() += static_cast<char>(std::tolower(c));
  }
  return words;
}

// By a word in a name, of a column that holds a date or only grows; -1 if there is none.
int FindByWord(const TableLayout& layout, const std::vector<std::vector<std::string>>& rows) {
  constexpr std::array<std::string_view, 5> kWords = {
      "timestamp", "stamp", "time", "timestamps", "datetime"};
  for (int i = 0; i < std::ssize(layout.columns); ++i) {
    const std::vector<std::string> words = WordsOf(layout.columns[i].name);
    const bool is_called_so = std::any_of(words.begin(), words.end(), [&](const auto& word) {
      return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
    });
    const bool is_clock =
        OnlyGrows(rows, i, layout.style.decimal) || ParseTextStamp(FirstCell(rows, i)).has_value();
    if (is_called_so && is_clock) return i;
  }
  return -1;
}

// Whether a column holds whole numbers that grow by 1 each row.
bool CountsRows(const std::vector<std::vector<std::string>>& rows, int column, char decimal) {
  std::optional<double> last;
  for (const auto& row : rows) {
    const auto number = ParseCell(Cell(row, column), decimal);
    if (!number || *number != std::floor(*number) || (last && *number != *last + 1.0)) return false;
    last = *number;
  }
  return rows.size() >= 3;
}

// The first column that only grows: the first of all, or behind one that counts rows another.
void FindGrowing(const TableLayout& layout,
                 const std::vector<std::vector<std::string>>& rows,
                 StampRule* rule) {
  const char decimal = layout.style.decimal;
  if (!OnlyGrows(rows, 0, decimal)) return;
  rule->column = 0;
  if (!CountsRows(rows, 0, decimal)) return;
  for (int i = 1; i < std::ssize(layout.columns); ++i) {
    if (!OnlyGrows(rows, i, decimal) || CountsRows(rows, i, decimal)) continue;
    rule->column = i;
    return;
  }
  rule->counts_rows = true;
}

// The first column beside `column` that holds days, or times of day; -1 if there is none.
int FindText(const std::vector<Field>& columns,
             const std::vector<std::vector<std::string>>& rows,
             bool has_date,
             int column) {
  for (int i = 0; i < std::ssize(columns); ++i) {
    const auto stamp = ParseTextStamp(FirstCell(rows, i));
    if (i != column && stamp && stamp->has_date == has_date) return i;
  }
  return -1;
}

void SetTextRule(const std::vector<Field>& columns,
                 const std::vector<std::vector<std::string>>& rows,
                 StampRule* rule) {
  rule->is_text = true;
  if (ParseTextStamp(FirstCell(rows, rule->column))->has_date) {
    const int times = FindText(columns, rows, /*has_date=*/false, rule->column);
    if (times >= 0) {
      rule->date_column = rule->column;
      rule->column = times;
    }
    rule->is_utc = true;
  } else {
    rule->date_column = FindText(columns, rows, /*has_date=*/true, rule->column);
    rule->is_utc = rule->date_column >= 0;
  }
}

// Seconds since 1970 are above 1e8 from 1973 on; the same in ms, us and ns.
void SetNumberRule(const Field& column,
                   const TableOptions& options,
                   double number,
                   const std::string& file,
                   StampRule* rule) {
  std::string unit = options.time_unit.empty() ? NameAndUnit(column).second : options.time_unit;
  if (unit.empty()) {
    unit = UnitOfStamp(number);
    rule->remark = fmt::format(
        "column {} states no unit: its stamps are taken as {}. Where they are in another, the name "
        "says so, as in 'time [ms]' or 'time_ms', or the map: 'table: {{time_unit: ms}}'.",
        Quoted(column.name),
        unit == "s" ? "seconds" : unit + " since 1970");
  }
  const auto found = FindUnit(unit, Dimension::kTime);
  if (!found) {
    throw InputError(
        fmt::format("{}: the stamps in column {} are in {}, expected one of {}. "
                    "Say which with 'time_unit'.",
                    file,
                    Quoted(column.name),
                    Quoted(unit),
                    UnitsOf(Dimension::kTime)));
  }
  rule->factor = found->factor;
  rule->is_utc = number * rule->factor > 1e8;
}

}  // namespace

int FindColumn(const std::vector<Field>& columns, std::string_view name) {
  const Field header = FieldOfHeader(name);
  const auto find = [&](const auto& is_meant) {
    const auto found = std::find_if(columns.begin(), columns.end(), is_meant);
    return found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
  };
  int index = find([&](const Field& field) { return field.name == name; });
  if (index < 0) {
    index = find(
        [&](const Field& field) { return field.name == header.name && field.unit == header.unit; });
  }
  if (index < 0) {
    index = find([&](const Field& field) {
      return field.number > 0 && std::to_string(field.number) == name;
    });
  }
  return index;
}

StampRule FindStamps(const std::string& file,
                     const TableLayout& layout,
                     const TableOptions& options,
                     const std::vector<std::vector<std::string>>& rows) {
  StampRule rule;
  if (!options.time.empty()) {
    rule.column = FindColumn(layout.columns, options.time);
    if (rule.column < 0) {
      throw InputError(
          fmt::format("{}: has no column {}, which 'time' names.", file, Quoted(options.time)));
    }
  } else {
    rule.column = FindByName(layout.columns);
    if (rule.column < 0) rule.column = FindByWord(layout, rows);
    if (rule.column < 0) rule.column = FindText(layout.columns, rows, /*has_date=*/true, -1);
    if (rule.column < 0) rule.column = FindText(layout.columns, rows, /*has_date=*/false, -1);
    if (rule.column < 0) FindGrowing(layout, rows, &rule);
  }
  if (rule.column < 0) return rule;
  const Field& column = layout.columns[rule.column];
  const std::string_view first = FirstCell(rows, rule.column);
  if (rule.counts_rows) {
    rule.remark = fmt::format(
        "column {} counts the rows and is taken for stamps of 1 s, as no other column could be. "
        "The "
        "map's 'rate' says how many rows a second has.",
        Quoted(column.name));
  } else if (ParseTextStamp(first)) {
    SetTextRule(layout.columns, rows, &rule);
  } else if (const auto number = ParseCell(first, layout.style.decimal)) {
    SetNumberRule(column, options, *number, file, &rule);
  } else {
    throw InputError(fmt::format(
        "{}:{}: column {} is {}, expected a stamp: a number, a date as 2026-05-03 14:30:05 or "
        "03.05.2026, or a time of day as 14:30:05. A date with slashes may have day or month "
        "first.",
        file,
        layout.first_row_line,
        Quoted(column.name),
        Quoted(first)));
  }
  return rule;
}

std::optional<double> StampReader::Read(const std::vector<std::string_view>& cells) {
  if (rule_.column < 0 || rule_.column >= std::ssize(cells)) return std::nullopt;
  if (!rule_.is_text) {
    const auto number = ParseCell(cells[rule_.column], decimal_);
    if (!number) return std::nullopt;
    return *number * rule_.factor;
  }
  const auto stamp = ParseTextStamp(cells[rule_.column]);
  if (!stamp) return std::nullopt;
  if (stamp->has_date) return stamp->seconds;
  if (rule_.date_column >= 0) {
    if (rule_.date_column >= std::ssize(cells)) return std::nullopt;
    const auto day = ParseTextStamp(cells[rule_.date_column]);
    if (!day || !day->has_date) return std::nullopt;
    return day->seconds + stamp->seconds;
  }
  if (last_ && stamp->seconds < *last_ - kDay / 2.0) midnight_ += kDay;
  last_ = stamp->seconds;
  return midnight_ + stamp->seconds;
}

}  // namespace fathom
