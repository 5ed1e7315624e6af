// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What tells the clock of one of several files.
struct ClockOfPart {
  std::string file;
  const Contents* contents = nullptr;
};

// Two files that count on two clocks of which nothing tells the difference.
struct ClockConflict {
  std::string first;  // their names
  std::string second;
  std::string why;  // names both
};

// How the stamps of several files come to lie on one clock. Files that tell the UTC of their stamp
// 0 are moved to the clock that begins first. GPS tells that UTC to about a second: two files of
// one format whose UTC differs by less than 3 s are of one start of the vehicle, and are not moved
// against each other. Files that do not tell it stay where they are, unless that cannot be right:
// two files of one format hold one channel at the same time, or those that tell it count on several
// clocks.
struct JoinedClocks {
  std::vector<double> shifts;         // [s], to be added to the stamps, for each file
  std::optional<double> utc_of_zero;  // of the common clock; nothing unless all files tell it
  std::vector<ClockConflict> conflicts;
  std::vector<std::string> remarks;  // what was moved
};

JoinedClocks JoinClocks(const std::vector<ClockOfPart>& parts);

}  // namespace fathom
