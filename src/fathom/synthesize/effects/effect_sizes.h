// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/random_stream.h"
#include "fathom/synthesize/effects/scales.h"
#include "fathom/vehicle/effect.h"

#include <array>
#include <vector>

namespace fathom {

// Values for an effect between just visible and large: even in their logarithm over a range that
// is stated for each parameter, in units of the experiment's own RMS command, RMS speed and
// duration; with a random sign where both are physical. `scales` by Index(Dof), as ScalesOf().
std::vector<double> DrawSizes(const Effect& effect,
                              Dof dof,
                              Dof partner,
                              const std::array<Scales, 6>& scales,
                              RandomStream& random);

}  // namespace fathom
