// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "damage.h"

#include <stdexcept>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kNumNuls = 37;

const char* UnitOf(const TwoColumnCsv& csv) {
  return csv.column.starts_with("tau") ? " [kN]" : " [cm/s]";
}

std::string WithLine(const std::string& text, int line, const std::string& replacement) {
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) begin = text.find('\n', begin) + 1;
  const std::size_t end = text.find('\n', begin);
  return text.substr(0, begin) + replacement + text.substr(end);
}

std::string WithCarriageReturns(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

}  // namespace

std::vector<Damage> AllDamages() {
  std::vector<Damage> all;
  for (int i = 0; i <= static_cast<int>(Damage::kNulTail); ++i) {
    all.push_back(static_cast<Damage>(i));
  }
  return all;
}

std::string Name(Damage damage) {
  constexpr const char* kNames[] = {"MissingTime",
                                    "MissingColumn",
                                    "NotANumber",
                                    "Nan",
                                    "EmptyCell",
                                    "TimeGoesBack",
                                    "StampTwice",
                                    "EmptyFile",
                                    "RaggedRow",
                                    "UnitInName",
                                    "UnitOfTime",
                                    "CarriageReturns",
                                    "ByteOrderMark",
                                    "NulTail"};
  return kNames[static_cast<int>(damage)];
}

std::ostream& operator<<(std::ostream& out, const TwoColumnCsv& csv) { return out << csv.file; }

std::ostream& operator<<(std::ostream& out, Damage damage) { return out << Name(damage); }

std::string Damaged(const std::string& text, const TwoColumnCsv& csv, Damage damage) {
  switch (damage) {
    case Damage::kMissingTime:
      return WithLine(text, 1, "clock," + csv.column);
    case Damage::kMissingColumn:
      return WithLine(text, 1, "t,speed");
    case Damage::kNotANumber:
      return WithLine(text, 5, "0.3,fast");
    case Damage::kNan:
      return WithLine(text, 5, "0.3,nan");
    case Damage::kEmptyCell:
      return WithLine(text, 5, "0.3,");
    case Damage::kTimeGoesBack:
      return WithLine(text, 5, "0.05,0.5");
    case Damage::kStampTwice:
      return WithLine(text, 5, "0.2,0.5");
    case Damage::kEmptyFile:
      return "";
    case Damage::kRaggedRow:
      return WithLine(text, 5, "0.3,0.5,0.7");
    case Damage::kUnitInName:
      return WithLine(text, 1, "t," + csv.column + UnitOf(csv));
    case Damage::kUnitOfTime:
      return WithLine(text, 1, "t_ms," + csv.column);
    case Damage::kCarriageReturns:
      return WithCarriageReturns(text);
    case Damage::kByteOrderMark:
      return "\xef\xbb\xbf" + text;
    case Damage::kNulTail:  // the last row is cut short too
      return text.substr(0, text.size() - 3) + std::string(kNumNuls, '\0');
  }
  throw std::logic_error("no such damage");
}

std::string Refusal(const TwoColumnCsv& csv, Damage damage) {
  const auto& [file, column, expected, is_one_of_several] = csv;
  constexpr char kAdvice[] = "Remove the row or repair it upstream; this reader does not guess.";
  switch (damage) {
    case Damage::kMissingTime:
      return fmt::format(
          ":1: column 't' is missing, found clock, {}; expected {}.", column, expected);
    case Damage::kMissingColumn:
      return fmt::format(
          ":1: {}, found t, speed; expected {}.",
          is_one_of_several ? "no column to read" : fmt::format("column '{}' is missing", column),
          expected);
    case Damage::kNotANumber:
      return fmt::format(
          ":5: column '{}' is 'fast', expected a number such as -0.25. {}", column, kAdvice);
    case Damage::kNan:
      return fmt::format(":5: column '{}' is 'nan', expected a finite number. {}", column, kAdvice);
    case Damage::kEmptyCell:
      return fmt::format(":5: column '{}' is empty, expected a finite number. {}", column, kAdvice);
    case Damage::kTimeGoesBack:
      return ":5: column 't' goes back from 0.2 to 0.05, expected rising stamps. Sort the rows, or "
             "split the log where its clock was reset.";
    case Damage::kStampTwice:
      return ":5: column 't' is 0.2 as on line 4, expected rising stamps. Remove one of the two "
             "rows, or write t with more digits.";
    case Damage::kEmptyFile:
      return ": is empty, expected a line of column names and rows of numbers.";
    case Damage::kRaggedRow:
      return ":5: the row has 3 cells, expected 2 as on line 1.";
    case Damage::kUnitInName:
      return fmt::format(
          ":1: column '{0}{1}' is '{0}' with a unit, expected SI units and plain names. Convert to "
          "SI and name the column '{0}'.",
          column,
          UnitOf(csv));
    case Damage::kUnitOfTime:
      return ":1: column 't_ms' is the time with a unit, expected SI units and plain names. "
             "Convert to SI and name the column 't'.";
    case Damage::kCarriageReturns:
      return ":1: the line ends in a carriage return, expected a line feed only. Convert the file "
             "with dos2unix.";
    case Damage::kByteOrderMark:
      return fmt::format(
          ":1: starts with a UTF-8 byte order mark, expected the first column name. Strip it (sed "
          "-i '1s/^\\xEF\\xBB\\xBF//' {}).",
          file);
    case Damage::kNulTail:
      return fmt::format(
          ":602: {} NUL bytes from this line to the end of the file, expected text. A power cut "
          "leaves such a tail. Cut it off (tr -d '\\0' < {} > cut.csv) and remove the last row if "
          "it is incomplete.",
          kNumNuls,
          file);
  }
  throw std::logic_error("no such damage");
}

}  // namespace fathom
