// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/challenge.h"

#include <functional>
#include <vector>

namespace fathom {

// What came of a search.
struct SearchResult {
  HypothesisBook book = {{}, {}};  // all that was tried, with what a suspect must gain
  bool is_cut = false;             // it ended because it had taken most_work
  std::vector<double> scores;      // by suspect: the best one on the baseline's own screen
};

// Whether a search ends with what it found among hypotheses of up to `size` causes.
using EndsSearch = std::function<bool(const HypothesisBook& book, int size)>;

// Searches the sets of up to wanted.most_causes suspects for the one that the data call for: they
// are screened linearly about the hypotheses at hand, the best of them refitted, the best
// hypothesis challenged cause by cause. `ends`: asked before one cause more is looked for.
// docs/diagnosis.md (6).
SearchResult SearchCauses(const TrainingData& data,
                          const StructureFit& baseline,
                          const std::vector<Suspect>& suspects,
                          const DiagnosisOptions& wanted,
                          const SearchOptions& options,
                          const EndsSearch& ends);

}  // namespace fathom
