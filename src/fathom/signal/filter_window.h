// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/split_at_gaps.h"

#include <span>

namespace fathom {

// The window [s] of a Savitzky-Golay filter of this order that the data ask for, docs/signal.md
// (4): chosen on the longest range to train on (or, without one, the longest there is).
double FilterWindowFor(std::span<const double> time,
                       std::span<const double> values,
                       std::span<const SampleRange> ranges,
                       int order);

}  // namespace fathom
