// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/options.h"
#include "fathom/diagnosis/search/search_result.h"
#include "fathom/diagnosis/search/suspects.h"

#include <vector>

namespace fathom {

// Searches the sets of up to options.most_causes suspects for the one that the data call for.
// docs/diagnosis.md (6).
SearchResult SearchCauses(const TrainingData& data,
                          const StructureFit& baseline,
                          const std::vector<Suspect>& suspects,
                          const DiagnosisOptions& options);

}  // namespace fathom
