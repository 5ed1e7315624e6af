// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/structure_ladder.h"
#include "fathom/coupled_planning/coupled_plan.h"

#include <string>

namespace fathom {

// An effect that a boat has, drawn between two sizes [unit of the entry].
struct HiddenCause {
  const char* entry;
  double least, most;
};

// A boat with a hidden cause, and the verdict on its first log of 200 s with coloured noise.
struct AmbiguousBoat {
  CoupledModel truth;
  FittedCoupledModel fitted;  // of the verdict
  std::string verdict;        // its file's text
};
AmbiguousBoat DrawAmbiguousBoat(const HiddenCause& hidden, unsigned seed);

// BoatRequest() with what the verdict leaves open.
CoupledPlanRequest RivalRequest(const AmbiguousBoat& boat, double duration, double effort);

// What the ladder names of a command that the truth played under the noise of the first log.
Ladder LadderOfPlayed(const CoupledModel& truth,
                      const CoupledCommand& command,
                      double duration,
                      unsigned seed);

}  // namespace fathom
