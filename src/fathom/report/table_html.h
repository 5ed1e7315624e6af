// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/table.h"

#include <string>

namespace fathom {

// The table as HTML, its flagged rows labelled "best" and "unusable".
std::string TableHtml(const Table& table);

}  // namespace fathom
