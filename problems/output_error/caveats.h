// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/output_error.h"
#include "fathom/signal/signals.h"

#include <span>
#include <string>

namespace fathom {

// Decides whether the data determine the model, and says in words what the intervals do not: which
// parameter this log cannot tell, why, and which experiment would. Reads summary->evidence, model
// and on_bound; fills determined, message and caveats.
void DescribeEvidence(std::span<const Segment> segments, OutputErrorSummary* summary);

// What to say of a damping that ended on its bound 0; `half_width` of the 95 % interval that it
// would have without the bound.
std::string CaveatOnBound(int parameter, double half_width);

}  // namespace fathom
