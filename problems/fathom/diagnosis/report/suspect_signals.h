// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What the missing force may depend on, at its instants.
struct SuspectSignal {
  std::string name;  // "command rate", "displacement"
  std::string unit;
  std::vector<double> values;
  bool is_time = false;  // which any slow force follows
};

// The signals that are there and change.
std::vector<SuspectSignal> SuspectSignalsOf(const Diagnosis& diagnosis);

// How much of a force the mean over a signal explains: a share of its variance; NaN if it has none.
double ShareExplainedBy(const SuspectSignal& signal, const std::vector<double>& force);

// The signal that explains most of what the causes leave of the missing force.
struct FollowedSignal {
  std::string name;
  double share = 0.0;
};

// Nothing where chance may explain as much: the force is smooth.
std::optional<FollowedSignal> FollowedByTheRest(const Diagnosis& diagnosis);

}  // namespace fathom
