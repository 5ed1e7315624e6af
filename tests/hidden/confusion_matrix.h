// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "score.h"

namespace fathom::hidden {

// Rows: what is hidden (one effect or nothing). Columns: what is named alone, then "group" (one
// that holds what is hidden), "other" (a group or part that does not) and "abstained". As Markdown
// code. `separable`: those that are clear and separable, and those with nothing hidden; else the
// others.
std::string ConfusionMatrix(const std::vector<LogScore>& scores, bool separable);

}  // namespace fathom::hidden
