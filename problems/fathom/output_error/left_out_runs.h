// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/options.h"
#include "fathom/output_error/summary.h"
#include "fathom/output_error/weighting.h"
#include "fathom/signal/segment.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

namespace fathom {

// A fit of the segments `kept` by plain or by learned weights.
using WeighedFit =
    std::function<OutputErrorSummary(std::span<const std::size_t> kept, Weighting weighting)>;

// How much more of runs that no fit has seen learned weights miss than plain ones, as a share of
// the RMS error: below 0 if less. Every segment is left out once, some at a time, four times at
// most; docs/output_error.md (15). Nothing of fewer than three segments, or where a fit fails.
// `options` and `plain`: of the fit of all segments.
std::optional<double> MoreMissedOfLeftOutRuns(std::span<const Segment> segments,
                                              const OutputErrorOptions& options,
                                              const OutputErrorSummary& plain,
                                              const WeighedFit& fit);

}  // namespace fathom
