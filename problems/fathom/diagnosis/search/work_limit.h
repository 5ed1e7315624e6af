// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/hypothesis_book.h"
#include "fathom/diagnosis/search/search_task.h"

namespace fathom {

// Whether the search for one cause more has to end. What it may take depends on what was found:
// SearchOptions::most_work where a hypothesis gains much, a share of that elsewhere.
bool IsSpent(const SearchTask& task, const HypothesisBook& book);

}  // namespace fathom
