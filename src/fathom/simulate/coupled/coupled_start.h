// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <cstddef>

namespace fathom {

// Where a free run starts at a sample of a segment: with the velocities from which the model's run
// fits the first two seconds behind it best (ten samples at least), in least squares, each DOF over
// what is missed of it, outliers left out: FittedStart() of several DOFs. Place and attitude are
// those of MeasuredState(), and so is all where the run diverges. A straight line through samples
// is no state where the motion bends.
CoupledState FittedCoupledStart(const CoupledModel& model,
                                const CoupledData& log,
                                const CoupledSegment& segment,
                                std::size_t sample);

}  // namespace fathom
