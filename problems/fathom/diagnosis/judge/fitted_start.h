// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/vehicle/extended_model.h"

#include <optional>

namespace fathom {

// The state from which a model's run fits the first two seconds of a segment (ten samples at least)
// best, in least squares: the speed, the place where it is measured, and what a sensor with a
// memory shows. Samples far from the others count for nothing. Nothing if the run diverges.
std::optional<InitialState> FittedStart(const MeasuredSegment& segment, const ExtendedModel& model);

}  // namespace fathom
