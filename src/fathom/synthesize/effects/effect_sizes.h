// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/random_stream.h"
#include "fathom/vehicle/effect.h"
#include "fathom/vehicle/scales.h"

#include <array>
#include <vector>

namespace fathom {

// Values for an effect between just visible and large: even in their logarithm over the range of
// each parameter (EffectParameter::drawn; NaN without one), in units of the experiment's own
// scales; with a random sign where both are physical. `scales` by Index(Dof), as ScalesOf().
std::vector<double> DrawSizes(const Effect& effect,
                              Dof dof,
                              Dof partner,
                              const std::array<Scales, 6>& scales,
                              RandomStream& random);

}  // namespace fathom
