// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/search/search.h"

#include <vector>

namespace fathom {

// SearchCauses() over the thinned data: the cost of a search grows with the samples, and what it
// finds is confirmed on all of them (judge/confirmation.h).
SearchResult SearchThinned(const Prepared& prepared,
                           const std::vector<Suspect>& suspects,
                           const DiagnosisOptions& wanted);

}  // namespace fathom
