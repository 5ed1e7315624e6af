// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/measures/held_out.h"
#include "fathom/diagnosis/measures/left_out_blocks.h"

#include <memory>

namespace fathom {

// The user's model beside what is named (itself, where nothing is), by free runs.
struct FreeRunComparison {
  FitFigures train_before, train_after;  // from the states that the fits end with
  Scored unseen;  // on data that no fit has seen: held out, or blocks left out in turn
  Gain gain;      // of it

  // What was left out in turn; null where something is held out.
  std::shared_ptr<const LeftOutParts> parts = nullptr;
};

// The runs over what no fit has seen, of the user's model and of a fit's: held out, or `parts`.
Scored UnseenRuns(const Prepared& prepared,
                  const LeftOutParts& parts,
                  const StructureFit& fit,
                  Criterion criterion);

// `fit`: of all training data, by `criterion`. `parts`: where nothing is held out.
FreeRunComparison CompareWithUsers(const Prepared& prepared,
                                   std::shared_ptr<const LeftOutParts> parts,
                                   const StructureFit& fit,
                                   Criterion criterion,
                                   bool acts_on_poses_alone);

// Nothing is named: the user's model twice.
FreeRunComparison OfUsersAlone(FreeRunComparison runs);

}  // namespace fathom
