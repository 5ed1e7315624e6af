// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace fathom {

// A file of docs/file_formats.md that a test damages: two columns, `t` and `column`, 601 rows
// stamped 0.0, 0.1, ... 60.0.
struct TwoColumnCsv {
  std::string file;               // "velocity.csv"
  std::string column;             // "u"
  std::string expected;           // as messages list it: "t and at least one of u, v, w, p, q, r"
  bool is_one_of_several = true;  // false: no other column can stand for it
};

// What logs come with in practice.
enum class Damage {
  kMissingTime,
  kMissingColumn,
  kNotANumber,
  kNan,
  kEmptyCell,
  kTimeGoesBack,
  kStampTwice,
  kEmptyFile,
  kRaggedRow,
  kUnitInName,
  kUnitOfTime,
  kCarriageReturns,
  kByteOrderMark,
  kNulTail,
};

std::vector<Damage> AllDamages();

// "TimeGoesBack".
std::string Name(Damage damage);

// `text`, the content of `csv`, with the damage done. Damage to a row is done to line 5, t = 0.3.
std::string Damaged(const std::string& text, const TwoColumnCsv& csv, Damage damage);

// For GoogleTest, which would print bytes.
std::ostream& operator<<(std::ostream& out, const TwoColumnCsv& csv);
std::ostream& operator<<(std::ostream& out, Damage damage);

// What docs/file_formats.md, "Refusals", promises for it, from behind the file's path on.
std::string Refusal(const TwoColumnCsv& csv, Damage damage);

}  // namespace fathom
