// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/search/search.h"

#include <functional>
#include <vector>

namespace fathom {

// A search by one criterion, over thinned data.
struct WeighedSearch {
  Criterion criterion = Criterion::kLearnedNoise;
  std::vector<Suspect> suspects;
  SearchResult found;
  TrainingData thinned = TrainingData({});  // that it is over
  StructureFit baseline;                    // by the same criterion, to all data
};

// SearchCauses() by likelihood, the noise learned along.
WeighedSearch SearchByLikelihood(const Prepared& prepared,
                                 const std::vector<Suspect>& suspects,
                                 const DiagnosisOptions& wanted,
                                 const EndsSearch& ends);

// SearchCauses() by what free runs miss, for effects of the vehicle alone: what belongs to a run
// fits what else is missing in it too well to be weighed so. `ends`: as EndsSearch.
WeighedSearch SearchByFreeRuns(const Prepared& prepared,
                               const std::vector<Suspect>& suspects,
                               const DiagnosisOptions& wanted,
                               const std::function<bool(const WeighedSearch&, int size)>& ends);

}  // namespace fathom
