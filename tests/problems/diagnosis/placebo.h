// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <cstdint>
#include <string>

namespace fathom {

// A log along surge beside columns that cannot be causes, in the places of sway and yaw: tau_sway
// is another log's command, tau_yaw this one's reversed in time, v another log's velocity, r this
// one's reversed in time. Every fourth seed hides nothing, the others one effect of the catalogue
// that needs no partner.
struct PlaceboLog {
  Log log;
  std::string hidden;  // as --effects; empty: nothing
};
PlaceboLog PlaceboLogOf(std::uint64_t seed);

struct PlaceboResult {
  std::string text;             // what was hidden, and what was named
  bool is_offered = false;      // effects of sway and of yaw were among the candidates
  bool is_named = false;        // one of them is a cause
  bool is_alternative = false;  // or said to be no worse than one
};
PlaceboResult TryPlacebo(std::uint64_t seed);

}  // namespace fathom
