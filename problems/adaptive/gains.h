// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// Gains of the adaptive law, docs/adaptive.md (1) and (2).
struct AdaptiveGains {
  double a_m = std::numeric_limits<double>::quiet_NaN();  // [1/s], below 0

  // Lambda, of alpha, beta, mu and nu in this order; above 0.
  std::array<double, 4> lambda = {std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN()};

  // Every broken rule, a sentence each; empty if the gains can be used.
  std::vector<std::string> Problems() const;
};

// Gains from the data, without tuning by hand: those whose one pass over `segments` ends in the
// model with the best free run over the same segments. Deterministic. NaN if the segments hold no
// force or no motion, or if no gains converge.
AdaptiveGains ChooseGains(std::span<const Segment> segments);

// Gains for a stream of which nothing is logged yet: from a typical (rms) force, a typical speed
// [m/s or rad/s] and the period of the motion [s], all above 0. A rule of thumb;
// docs/adaptive.md.
AdaptiveGains RuleOfThumbGains(double force, double speed, double period);

}  // namespace fathom
