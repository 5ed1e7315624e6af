// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/fit/remaining_structure.h"
#include "fathom/diagnosis/judge/refutation.h"
#include "fathom/diagnosis/measures/evidence.h"
#include "fathom/diagnosis/measures/free_run_comparison.h"
#include "fathom/diagnosis/options.h"
#include "fathom/diagnosis/result.h"

#include <optional>
#include <vector>

namespace fathom {

// What is named, what is refused, and what both rest on.
struct Judgement {
  Verdict verdict = Verdict::kConsistent;
  WeighedSearch search;     // that what is named comes from
  Choice choice;            // what is named and refused: of the search, or the baseline
  std::vector<int> rivals;  // FindRivals() of it
  Evidence evidence;
  FreeRunComparison runs;
  RemainingStructure remaining;  // that what is named leaves
  std::optional<Coincidence> coincidence;
  bool is_only_cut = false;  // unexplained since the search was ended before it was through

  const HypothesisBook& book() const { return search.found.book; }

  // False where it was looked for and the data are too few.
  bool IsRemainingTried() const { return remaining.is_negligible || remaining.num_columns > 0; }
};

// Confirms the best hypothesis of a search by likelihood on all training data, asks the data that
// no fit has seen for each of its causes and for all of them, and looks for what it leaves. Where
// its free run leaves more than scatter, the noise may have taken up what is missing: then free
// runs propose causes too, and those stand that predict unseen data better for certain.
// docs/diagnosis.md, "Verdict".
Judgement Judge(const Prepared& prepared,
                const std::vector<Suspect>& suspects,
                const Evidence& evidence,
                const DiagnosisOptions& options);

}  // namespace fathom
