// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/csv/csv_table.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/not_finite.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/log/csv/csv_rows.h"
#include "fathom/log/csv/unit_suffix.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr int kNotRead = -1;
constexpr int kTime = -2;

bool Contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "thruster_12" for the prefix "thruster_".
bool IsNumbered(std::string_view column, std::string_view prefix) {
  if (prefix.empty() || !column.starts_with(prefix)) return false;
  const std::string_view number = column.substr(prefix.size());
  return !number.empty() && number.front() != '0' &&
         number.find_first_not_of("0123456789") == std::string_view::npos;
}

// "fin_rudder" for the prefix "fin_".
bool IsNamed(std::string_view column, const std::vector<std::string>& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(), [&](const std::string& prefix) {
    return column.starts_with(prefix) && column.size() > prefix.size();
  });
}

// "du, dv, dw", cut after 40 names.
std::string ListOf(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 40;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    shown.push_back(Printable(names[i]));
  if (names.size() > kMost) shown.push_back(fmt::format("... ({} in all)", names.size()));
  return fmt::format("{}", fmt::join(shown, ", "));
}

std::string Expected(const CsvSpec& spec) {
  std::vector<std::string> required = {"t"};
  required.insert(required.end(), spec.required.begin(), spec.required.end());
  std::vector<std::string> any = spec.at_least_one_of;
  if (!spec.numbered.empty()) any.push_back(spec.numbered + "1, " + spec.numbered + "2, ...");
  for (const std::string& prefix : spec.named) any.push_back(prefix + "<name>");
  std::string expected = fmt::format("{}", fmt::join(required, ", "));
  if (!any.empty()) expected += fmt::format(" and at least one of {}", fmt::join(any, ", "));
  return expected;
}

// What each column of the file is: kTime, kNotRead or its index in the stream.
class Header {
 public:
  Header(const std::string& name,
         int line,
         const std::vector<std::string_view>& cells,
         const CsvSpec& spec,
         CsvTable* table)
      : name_(name), line_(line), cells_(cells.begin(), cells.end()), spec_(spec) {
    RefuseWhatHoldsNoNames();
    RefuseRepeatedNames();
    for (const std::string& cell : cells_) {
      if (cell == "t") {
        roles_.push_back(kTime);
      } else if (Contains(spec.required, cell) || IsOneOfTheSubset(cell)) {
        roles_.push_back(static_cast<int>(table->stream.columns.size()));
        table->stream.columns.push_back(cell);
      } else {
        RefuseUnit(cell);
        roles_.push_back(kNotRead);
        table->not_read.push_back(cell);
      }
    }
    RefuseMissingColumns(table->stream.columns);
    table->stream.values.resize(table->stream.columns.size());
  }

  const std::vector<std::string>& names() const { return cells_; }
  int role(std::size_t column) const { return roles_[column]; }

 private:
  [[noreturn]] void Fail(std::string_view problem) const {
    throw InputError(fmt::format("{}:{}: {}", name_, line_, problem));
  }

  bool IsOneOfTheSubset(const std::string& cell) const {
    return Contains(spec_.at_least_one_of, cell) || IsNumbered(cell, spec_.numbered) ||
           IsNamed(cell, spec_.named);
  }

  void RefuseWhatHoldsNoNames() const {
    if (cells_.size() == 1 && cells_[0].find_first_of(";\t") != std::string::npos) {
      // The line may be anybody's: it does not stand in the message.
      Fail(fmt::format("the columns are separated by {}, expected commas.",
                       cells_[0].find(';') != std::string::npos ? "';'" : "tabs"));
    }
    if (std::all_of(cells_.begin(), cells_.end(), [](const std::string& cell) {
          return ParseFiniteNumber(cell).has_value();
        })) {
      Fail(fmt::format("the first line holds numbers, expected the column names {}.",
                       Expected(spec_)));
    }
  }

  void RefuseRepeatedNames() const {
    std::map<std::string_view, std::size_t> first;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (cells_[i].empty()) Fail(fmt::format("column {} has no name, expected one.", i + 1));
      const auto [same, is_new] = first.emplace(cells_[i], i);
      if (!is_new) {
        Fail(fmt::format("column {} stands twice, as column {} and {}. Remove or rename one.",
                         Quoted(cells_[i]),
                         same->second + 1,
                         i + 1));
      }
    }
  }

  void RefuseUnit(const std::string& cell) const {
    std::vector<std::string> known = {"t"};
    known.insert(known.end(), spec_.required.begin(), spec_.required.end());
    known.insert(known.end(), spec_.at_least_one_of.begin(), spec_.at_least_one_of.end());
    if (!spec_.numbered.empty() && cell.starts_with(spec_.numbered)) {
      const std::size_t end = cell.find_first_not_of("0123456789", spec_.numbered.size());
      known.push_back(cell.substr(0, end));
    }
    if (const auto name = NameWithoutUnit(cell, known)) {
      Fail(fmt::format(
          "column {} is {} with a unit, expected SI units and plain names. Convert to SI "
          "and name the column '{}'.",
          Quoted(cell),
          *name == "t" ? "the time" : Quoted(*name),
          *name));
    }
  }

  void RefuseMissingColumns(const std::vector<std::string>& read) const {
    std::string missing;
    for (const std::string& column : spec_.required) {
      if (missing.empty() && !Contains(read, column))
        missing = "column '" + column + "' is missing";
    }
    if (!Contains(cells_, "t")) missing = "column 't' is missing";
    const bool needs_one = !spec_.at_least_one_of.empty() || !spec_.numbered.empty();
    if (missing.empty() && needs_one &&
        std::none_of(read.begin(), read.end(), [&](const std::string& column) {
          return IsOneOfTheSubset(column);
        })) {
      missing = "no column to read";
    }
    if (missing.empty()) return;
    Fail(fmt::format("{}, found {}; expected {}.", missing, ListOf(cells_), Expected(spec_)));
  }

  const std::string& name_;
  const int line_;
  const std::vector<std::string> cells_;
  const CsvSpec& spec_;
  std::vector<int> roles_;
};

double NumberOf(const std::string& name,
                int line,
                const std::string& column,
                std::string_view cell) {
  if (const auto number = ParseFiniteNumber(cell)) return *number;
  const std::string place = fmt::format("{}:{}: column {} is ", name, line, Quoted(column));
  constexpr char kAdvice[] = "Remove the row or repair it upstream; this reader does not guess.";
  if (cell.empty()) throw InputError(place + "empty, expected a finite number. " + kAdvice);
  if (MeansNoFiniteNumber(cell)) {
    throw InputError(
        fmt::format("{}{}, expected a finite number. {}", place, Quoted(cell), kAdvice));
  }
  throw InputError(
      fmt::format("{}{}, expected a number such as -0.25. {}", place, Quoted(cell), kAdvice));
}

void AppendStamp(double t, int line, bool allow_equal, CsvTable* table) {
  auto& time = table->stream.time;
  if (!time.empty() && t < time.back()) {
    throw InputError(
        fmt::format("{}:{}: column 't' goes back from {} to {}, expected rising stamps. Sort the "
                    "rows, or split the "
                    "log where its clock was reset.",
                    table->name,
                    line,
                    time.back(),
                    t));
  }
  if (!time.empty() && t == time.back() && !allow_equal) {
    throw InputError(
        fmt::format("{}:{}: column 't' is {} as on line {}, expected rising stamps. Remove one of "
                    "the two rows, or "
                    "write t with more digits.",
                    table->name,
                    line,
                    t,
                    table->line_of_row.back()));
  }
  time.push_back(t);
}

void Reserve(std::size_t num_rows, CsvTable* table) {
  table->stream.time.reserve(num_rows);
  for (std::vector<double>& column : table->stream.values) column.reserve(num_rows);
  table->line_of_row.reserve(num_rows);
}

}  // namespace

std::string CsvTable::Remark() const {
  if (not_read.empty()) return "";
  const bool is_one = not_read.size() == 1;
  return fmt::format("{}: {} further column{} not read: {}.",
                     std::filesystem::path(name).filename().string(),
                     not_read.size(),
                     is_one ? " is" : "s are",
                     ListOf(not_read));
}

CsvTable ReadCsvTable(const std::filesystem::path& path, const CsvSpec& spec) {
  return ParseCsvTable(path.string(), ReadFile(path), spec);
}

CsvTable ParseCsvTable(const std::string& name, const std::string& text, const CsvSpec& spec) {
  CsvTable table;
  table.name = name;
  std::optional<Header> header;
  ForEachCsvRow(name, text, [&](int line, const std::vector<std::string_view>& cells) {
    if (!header) {
      header.emplace(name, line, cells, spec, &table);
      Reserve(std::count(text.begin(), text.end(), '\n'), &table);
      return;
    }
    const auto& names = header->names();
    if (cells.size() != names.size()) {
      throw InputError(fmt::format("{}:{}: the row has {} cells, expected {} as on line 1.",
                                   name,
                                   line,
                                   cells.size(),
                                   names.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const int role = header->role(i);
      if (role == kNotRead) continue;
      const double number = NumberOf(name, line, names[i], cells[i]);
      if (role == kTime) {
        AppendStamp(number, line, spec.allow_equal_stamps, &table);
      } else {
        table.stream.values[role].push_back(number);
      }
    }
    table.line_of_row.push_back(line);
  });
  const std::size_t num_rows = table.line_of_row.size();
  if (num_rows < 2) {
    throw InputError(fmt::format("{}:{}: {} after the column names, expected at least two rows.",
                                 name,
                                 num_rows + 1,
                                 num_rows == 0 ? "no row" : "only one row"));
  }
  return table;
}

}  // namespace fathom
