// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace fathom {

// How far a free-running simulation is from the measured velocity. NaN: not computed.
struct FitFigures {
  double mae = std::numeric_limits<double>::quiet_NaN();   // [m/s] or [rad/s], docs/models.md (7)
  double nmae = std::numeric_limits<double>::quiet_NaN();  // no unit, docs/models.md (8)
  int num_samples = 0;
  double duration = 0.0;  // [s], summed over the segments
};

// The velocity that `model` predicts at the stamps of `segment` from its command alone, started
// from the segment's first measured velocity: a free run, the measurement never enters again.
// Nothing if the simulation diverges.
std::optional<std::vector<double>> PredictVelocity(const UncoupledModel<double>& model,
                                                   const Segment& segment);

// MAE and NMAE of the free runs over all `segments` together (paper Eqs. 10 and 11). The figures
// are NaN if there are no segments or a run diverges.
FitFigures FiguresOf(const UncoupledModel<double>& model, std::span<const Segment> segments);

}  // namespace fathom
