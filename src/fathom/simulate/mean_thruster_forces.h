// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/effect_inputs.h"
#include "fathom/vehicle/extended_model.h"

#include <span>
#include <vector>

namespace fathom {

// The mean force behind the thrusters of a model [N] or [N m] from each time to the next, in log
// time [s], rising: one value less than times. What depends on the speed through the water is not
// counted: EffectLaw::thrust_at_speed.
std::vector<double> MeanThrusterForces(const EffectInputs& inputs,
                                       const ExtendedModel& model,
                                       std::span<const double> times);

}  // namespace fathom
