// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/judge/confirmation.h"
#include "fathom/diagnosis/judge/verdict_rules.h"
#include "fathom/diagnosis/measures/free_run_comparison.h"

#include <memory>

namespace fathom {

// What a search by free runs proposes and unseen data bear out.
struct Rung {
  Choice choice;  // the baseline where nothing is
  FreeRunComparison runs;
};

// Climbs from the user's model to hypotheses of one, two and three causes. Of each size the best
// two on the training data are tried; one is taken if it predicts data that no fit has seen better
// than what stands, for certain by a twentieth (by a fifth, where they are too few for an
// interval). `parts`: what is left out in turn, where nothing is held out.
Rung ClimbByFreeRuns(const Prepared& prepared,
                     const WeighedSearch& search,
                     const std::shared_ptr<const LeftOutParts>& parts,
                     int most_causes,
                     const VerdictRules& rules = {});

// Whether the second model's runs are better than the first's, as a rung is asked to be.
bool IsBetterForCertain(const Gain& gain, const VerdictRules& rules = {});

}  // namespace fathom
