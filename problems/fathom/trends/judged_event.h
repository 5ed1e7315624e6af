// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/event_fit.h"
#include "fathom/trends/pattern.h"
#include "fathom/trends/pattern_fit.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// A cause that an event's differences agree with.
struct NamedCause {
  std::string cause = "unnamed";
  Pattern pattern;  // empty for "unnamed"
  PatternFit fit;
};

// What an event's differences say of its cause.
struct JudgedEvent {
  std::vector<NamedCause> causes;         // one; two that act from the same dive on
  std::vector<std::string> alternatives;  // that fit about as well
};

// The cause with the least misfit and price of free numbers, if it fits (p > 0.01); those within 6
// of it are alternatives. Where no cause fits alone, two together have to be better by 6 than any
// alone; where these do not fit either, "unnamed": archive_trends.md (8).
JudgedEvent Judge(const EventFit& event, std::span<const Pattern> patterns, int num_dives);

}  // namespace fathom
