// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/options.h"
#include "fathom/output_error/summary.h"
#include "fathom/signal/segment.h"

#include <span>

namespace fathom {

// Parameters and initial states for which the free-running simulation of all `segments` (of one log
// or several) comes closest to what was measured; docs/output_error.md. Inertia is positive, both
// dampings at least 0.
//
// Throws InputError if options.Problems() is not empty or the segments lack the asked output. A
// poor fit does not throw: see the summary.
OutputErrorSummary FitOutputError(std::span<const Segment> segments,
                                  const OutputErrorOptions& options = {});

// What a fit is compared with by default: poses as they are, without a derivative between image and
// model, where all of them are displacements along the DOF; else velocities.
FittedOutput OutputOf(std::span<const Segment> segments);

}  // namespace fathom
