// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"

#include <optional>

namespace fathom {

// What of a segment lies within [from, to] [s], its state guessed anew; nothing if that is fewer
// than `least` samples.
std::optional<MeasuredSegment> PartOf(const MeasuredSegment& segment,
                                      double from,
                                      double to,
                                      size_t least = 20);

}  // namespace fathom
