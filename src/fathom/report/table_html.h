// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/table.h"

#include <string>

namespace fathom {

// The table as HTML, its flagged rows labelled "best" and "unusable". Where it does not fit,
// page.js makes each row a block, whose lines are a heading and a cell each.
std::string TableHtml(const Table& table);

}  // namespace fathom
