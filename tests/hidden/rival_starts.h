// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/extended_model.h"

#include <vector>

#include "effect_size.h"
#include "known_noise_fit.h"
#include "known_run.h"

namespace fathom::hidden {

// Where to start the fit of `effect` (its values are not read) on top of `fitted`: a few models of
// which the linear forecast is best among many sizes, times, frequencies and shapes. Effects are in
// the order of the catalogue in all of them.
std::vector<ExtendedModel> StartsFor(const KnownRun& run,
                                     const KnownNoiseFit& fitted,
                                     const RunScales& scales,
                                     const ActiveEffect& effect);

}  // namespace fathom::hidden
