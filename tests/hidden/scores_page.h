// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "score.h"

namespace fathom::hidden {

// The page docs/diagnosis_scores.md. `command` is how it was made.
std::string ScoresPage(const std::vector<LogScore>& scores, const std::string& command);

// The figures next to their bars, a line each.
std::string Summary(const std::vector<LogScore>& scores);

// One log: what was hidden, what the oracle says, what was named, where it was.
std::string Line(const LogScore& score);

}  // namespace fathom::hidden
