// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/gains.h"
#include "fathom/signal/segment.h"

#include <span>

namespace fathom {

// Gains from the data, without tuning by hand: those whose one pass over `segments` ends in the
// model with the best free run over the same segments. Deterministic. NaN if the segments hold no
// force or no motion, or if no gains converge.
AdaptiveGains ChooseGains(std::span<const Segment> segments);

// Gains for a stream of which nothing is logged yet: from a typical (rms) force, a typical speed
// [m/s or rad/s] and the period of the motion [s], all above 0. A rule of thumb;
// docs/adaptive.md.
AdaptiveGains RuleOfThumbGains(double force, double speed, double period);

}  // namespace fathom
