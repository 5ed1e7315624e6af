// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/segment.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <span>

namespace fathom {

// By what share of itself one Gauss-Newton step of output error would change the inertia of
// `model`, all four parameters and the speed at each segment's first stamp being free;
// docs/adaptive.md (4). Near 0 where the model is what the velocities ask for. NaN if the
// simulation diverges or the segments do not determine the parameters.
double InertiaStep(const UncoupledModel<double>& model, std::span<const Segment> segments);

}  // namespace fathom
