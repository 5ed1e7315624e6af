// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"

#include <span>

namespace fathom {

// How much of its time is proposed to be held out of a log.
inline constexpr double kHeldOutShare = 0.25;

// What to hold out: the end of `stretches` that holds that share of their time. They are in their
// order, at least one.
TimeInterval ProposedHeldOut(std::span<const TimeInterval> stretches);

}  // namespace fathom
