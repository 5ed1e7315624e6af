// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"
#include "fathom/log/held_command.h"
#include "fathom/signal/segment.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// Where in a log command and motion change enough to learn from.
struct Excitation {
  std::vector<TimeInterval> stretches;  // of the motion's stamps, in their order [s]
  double excited = 0.0;                 // all stretches together [s]
  double duration = 0.0;                // of all segments [s]

  // What to hold out: ProposedHeldOut() of the stretches. Nothing where less than 40 s are
  // excited: too little is left to learn from, or to judge by.
  std::optional<TimeInterval> held_out;
};

// Looks at blocks of 5 s: one is excited if, with its neighbours, the command and the velocity each
// span a fifth of what they span in the whole log (between the 1 % and 99 % quantiles).
Excitation ExcitationOf(const HeldCommand& command, std::span<const Segment> segments);

}  // namespace fathom
