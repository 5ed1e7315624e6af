// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"
#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/search/significance.h"

#include <vector>

namespace fathom {

// A set of suspects with the model that has them all.
struct Hypothesis {
  std::vector<int> suspects;  // indices, ascending; none: the baseline
  StructureFit fit;

  // 2 log-likelihood over the baseline's, less PriceOfStarts().
  double gain = 0.0;

  // BIC of the baseline less its own: above 0, better than the baseline.
  double delta_bic = 0.0;
};

// What was tried and what came of it.
struct SearchResult {
  std::vector<Hypothesis> tried;  // the baseline first, then as they came
  int best = 0;                   // index into `tried`

  std::vector<int> rivals;  // FindRivals() of the best

  Significance significance;  // of what a suspect gains
  // By suspect: what it must gain alone, and beside other causes.
  std::vector<double> thresholds, thresholds_beside;

  // Per suspect: the best score of the linear screens about the baseline.
  std::vector<double> scores;

  // By suspect: refitted alone, and no model that means something came of it: it cannot be
  // simulated, leaves the inertia open, or has a tone where the command has its own.
  std::vector<bool> failed_alone;
};

// False where a cause presses on a bound of what is physical: the data ask for something else.
bool IsPhysical(const Hypothesis& hypothesis);

// What a set of suspects must gain over the baseline.
double ThresholdOf(const SearchResult& search, const std::vector<int>& suspects);

// Indices of hypotheses that explain the data as well as the best one, each with one of its
// suspects replaced: worse by less than `separation` (DiagnosisOptions).
std::vector<int> FindRivals(const TrainingData& data,
                            const SearchResult& search,
                            double separation);

// The hypothesis with exactly these suspects; null if it was not tried.
const Hypothesis* FindHypothesis(const SearchResult& search, const std::vector<int>& suspects);

// That hypothesis less one of its suspects; null if it was not tried.
const Hypothesis* FindWithout(const SearchResult& search, int index, int suspect);

}  // namespace fathom
