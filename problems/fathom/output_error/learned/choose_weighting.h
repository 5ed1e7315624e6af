// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/options.h"
#include "fathom/output_error/summary.h"
#include "fathom/signal/segment.h"

#include <span>

namespace fathom {

// The answer weighed as options.weighting asks, given the plain one: that, or the one under the
// learned noise; docs/output_error.md (10) to (14). Its weighting_reason says why.
OutputErrorSummary ChooseWeighting(std::span<const Segment> segments,
                                   const OutputErrorOptions& options,
                                   OutputErrorSummary plain);

}  // namespace fathom
