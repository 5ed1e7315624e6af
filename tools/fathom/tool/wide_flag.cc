// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/wide_flag.h"

#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"

#include <cstddef>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_bool(wide, false, "Print all columns of the tables, not only those that fit into 100.");

namespace fathom {

Table ShownInTerminal(const Table& table, std::vector<std::string>* left_out) {
  constexpr std::size_t kWidth = 100;
  return FLAGS_wide ? table : Narrowed(table, kWidth, left_out);
}

std::string TableForTerminal(const Table& table) {
  std::vector<std::string> left_out;
  const std::string text = ShownOnLines(FormatTable(ShownInTerminal(table, &left_out)));
  if (left_out.empty()) return text;
  return text + fmt::format("({} more with --wide)\n", Plural(left_out.size(), "column"));
}

}  // namespace fathom
