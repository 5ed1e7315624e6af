// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/segment.h"

#include <span>
#include <vector>

namespace fathom {

// The segments with a sample for every few of theirs, for a search that only looks for where
// another one starts: the means of the measurements, under the mean forces between them, at most
// 0.25 s apart. The columns for least squares, smooth already, are those of the middle samples.
// Empty where the samples are too few for that.
std::vector<Segment> CoarseSegments(std::span<const Segment> segments);

}  // namespace fathom
