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

}  // namespace fathom
