// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"

#include <vector>

namespace fathom {

// Segments that last longer than `most` [s] together, cut down to that: of each the same share, in
// pieces of about five minutes that are spread evenly over it. A search among hundreds of models
// then costs the same however long a log is; docs/diagnosis.md (2).
std::vector<MeasuredSegment> Excerpt(std::vector<MeasuredSegment> segments, double most);

// Of all segments [s].
double DurationOf(const std::vector<MeasuredSegment>& segments);

}  // namespace fathom
