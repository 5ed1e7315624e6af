// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/measures/held_out.h"
#include "fathom/diagnosis/search/thinned_search.h"

#include <map>
#include <vector>

namespace fathom {

// Suspects that fit the training data and are not named, and why.
struct Refusal {
  enum class Reason {
    kFinerThanTheStamps,    // a delay or a lag under half of the step between samples
    kLosesBesideOthers,     // with it the error grows on data that no fit has seen
    kGainsNothing,          // it gains nothing for certain on them, and there is more to explain
    kLosesOnUnseenData,     // all that was chosen: `loss`
    kLosesInTraining,       // the same on the training data: `nmae_before`, `nmae_after`
    kTwoLogsTellTooLittle,  // only two, and what it leaves is more than noise
    kNotConfirmedByLogs,    // logs that are left out, each in turn, do not gain by it: `loss`
  };
  Reason reason = Reason::kLosesBesideOthers;
  std::vector<int> refused = {};  // indices of suspects
  std::vector<int> kept = {};     // beside which they are refused
  Gain loss = {};                 // below 0; of kNotConfirmedByLogs the gain there is
  double nmae_before = 0.0, nmae_after = 0.0;
};

// The hypothesis of a search that stands for the data, with fits to all of them; the search itself
// is over thinned ones.
struct Choice {
  int chosen = 0;                      // in the search's book; 0: the baseline
  std::map<int, StructureFit> fits;    // to all data: of the baseline, and of all that were chosen
  std::vector<Refusal> refusals = {};  // in the order in which they were made

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
