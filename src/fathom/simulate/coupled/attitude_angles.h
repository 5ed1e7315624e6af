// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_simulation.h"

namespace fathom {

// The angle between the body's down and the world's [rad].
double TiltOf(const CoupledState& state);

// Between the body's x axis, seen from above, and the world's, to starboard, by the turn that is
// nearest to `before` [rad].
double UnwrappedHeading(const CoupledState& state, double before);

}  // namespace fathom
