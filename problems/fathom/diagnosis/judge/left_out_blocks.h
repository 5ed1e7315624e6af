// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/judge/held_out.h"

#include <vector>

namespace fathom {

// One part of logs that hold nothing out, and the rest of them.
struct LeftOut {
  std::vector<MeasuredSegment> left_out;
  TrainingData rest;
  ExtendedModel users;  // the user's model, by output error from the rest alone; where that finds
                        // none, that of all data
};

// How logs are parted.
enum class LeavingOut {
  kOfAll,      // a quarter of all data at a time
  kOfEachLog,  // of each log: what belongs to one log alone is known from its other blocks only
};

// The quarters; none if the data are too few.
std::vector<LeftOut> LeaveBlocksOut(const Prepared& prepared, LeavingOut leaving_out);

// Free runs over each part, of the user's model and of a structure that is fitted anew to the rest
// by its criterion (by likelihood: under its own noise).
Scored Score(const std::vector<LeftOut>& parts, const StructureFit& extended, Criterion criterion);

}  // namespace fathom
