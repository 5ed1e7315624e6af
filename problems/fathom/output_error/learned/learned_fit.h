// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/options.h"
#include "fathom/output_error/summary.h"
#include "fathom/signal/segment.h"

#include <span>

namespace fathom {

// Output error weighed by the noise that it learns along, docs/output_error.md (10), (11), on from
// a `plain` fit of the same segments. Where no noise can be learned, that fit, and why.
OutputErrorSummary FitUnderLearnedNoise(std::span<const Segment> segments,
                                        const OutputErrorOptions& options,
                                        OutputErrorSummary plain);

}  // namespace fathom
