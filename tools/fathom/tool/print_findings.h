// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"

#include <vector>

namespace fathom {

// What every tool does with what its checks found: warnings go to stderr, and before all else that
// it prints.
void PrintWarnings(const std::vector<Finding>& findings);

// The notes, to stdout.
void PrintNotes(const std::vector<Finding>& findings);

}  // namespace fathom
