// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"
#include "fathom/diagnosis/search/search_result.h"
#include "fathom/diagnosis/search/suspects.h"

#include <vector>

namespace fathom {

// The causes of the best hypothesis, in the order of its model's effects, each with what these
// records cannot tell from it and the experiment that would.
std::vector<Cause> CausesOf(const SearchResult& search, const std::vector<Suspect>& suspects);

// Every suspect with what became of it, the best first.
std::vector<Candidate> RankCandidates(const SearchResult& search,
                                      const std::vector<Suspect>& suspects);

// The best hypothesis's model without one of its causes, refitted if it was tried so.
ExtendedModel WithoutCause(const SearchResult& search,
                           const std::vector<Suspect>& suspects,
                           const Cause& cause);

}  // namespace fathom
