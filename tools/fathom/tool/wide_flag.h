// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/table.h"

#include <string>

namespace fathom {

// The table as a tool prints it: at most 100 columns wide where it can be, all of it with --wide. A
// line below counts the columns left out.
std::string TableForTerminal(const Table& table);

}  // namespace fathom
