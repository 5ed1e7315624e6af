// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/measures/held_out.h"

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
  kLogs,       // one log at a time, as a whole: blocks of one run share what is special about it
};

// All of them.
struct LeftOutParts {
  LeavingOut how = LeavingOut::kOfAll;
  std::vector<LeftOut> parts;  // empty where something is held out, or the data are too few
};

// How the data of a model are left out where nothing is held out: of several logs one at a time,
// unless all its effects are of one log each, which no other log knows.
LeavingOut HowToLeaveOut(const TrainingData& data, const ExtendedModel& model);

LeftOutParts LeaveOut(const Prepared& prepared, LeavingOut how);

// Free runs over each part, of the user's model and of a structure that is fitted anew to the rest
// by its criterion (by likelihood: under its own noise), without the effects of logs that are not
// in the rest.
Scored Score(const LeftOutParts& parts, const StructureFit& extended, Criterion criterion);

}  // namespace fathom
