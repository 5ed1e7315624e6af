// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/output_error.h"
#include "fathom/signal/signals.h"

#include <span>

namespace fathom {

// Decides whether the data determine the model, and says in words what the intervals do not: which
// parameter this log cannot tell, why, and which experiment would. Reads summary->evidence, model
// and on_bound; fills determined, message and caveats.
void DescribeEvidence(std::span<const Segment> segments, OutputErrorSummary* summary);

}  // namespace fathom
