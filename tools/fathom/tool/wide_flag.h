// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// What a tool prints of a table: no wider than 100 where it can be, all of it with --wide.
// `left_out`: the headings of what is not printed; may be null.
Table ShownInTerminal(const Table& table, std::vector<std::string>* left_out = nullptr);

// That as text. A line below counts the columns left out.
std::string TableForTerminal(const Table& table);

}  // namespace fathom
