// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/thinned_search.h"

#include <map>

namespace fathom {

// The hypothesis of a search that stands for the data, with fits to all of them; the search itself
// is over thinned ones.
struct Choice {
  int chosen = 0;                    // in the search's book; 0: the baseline
  std::map<int, StructureFit> fits;  // to all data: of the baseline, and of all that were chosen

  const StructureFit& fit() const { return fits.at(chosen); }
};

// The fit of any hypothesis: to all data where there is one, else the search's own.
const StructureFit& FitOf(const HypothesisBook& book, const Choice& choice, int index);

// Fits the best hypothesis of a search to all data, and takes from it every cause that they do not
// call for: what answers to the thinning itself shows here.
Choice ConfirmedOnAllData(const TrainingData& data, const WeighedSearch& search);

// The same choice with another hypothesis, fitted to all data; the baseline where that cannot be
// simulated.
Choice WithChosen(const TrainingData& data, const WeighedSearch& search, int index, Choice choice);

}  // namespace fathom
