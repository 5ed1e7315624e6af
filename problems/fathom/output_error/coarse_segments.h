// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/segment.h"

#include <span>
#include <vector>

namespace fathom {

// The segments with a sample for every few of theirs, for a search that only looks for where
// another one starts: the means of the measurements, under the mean forces between them, at most
// 0.25 s apart. Empty where the samples are too few for that. Only time, velocity, position and
// command are filled.
std::vector<Segment> CoarseSegments(std::span<const Segment> segments);

}  // namespace fathom
