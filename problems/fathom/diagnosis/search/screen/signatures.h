// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/force_response.h"
#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/search/screen/trial.h"
#include "fathom/diagnosis/search/suspect.h"

#include <span>
#include <vector>

namespace fathom {

// What each trial adds to the outputs of a fitted model, in the columns that the trials name; rows:
// bins. Forces, of the water and of the thrusters, by the model's linearised `response`; what poses
// alone show, from its run; the rest by simulation.
RowMajorMatrix SignaturesOf(const TrainingData& data,
                            const ForceResponse& response,
                            const StructureFit& fit,
                            const std::vector<Suspect>& suspects,
                            std::span<const Trial> trials);

}  // namespace fathom
