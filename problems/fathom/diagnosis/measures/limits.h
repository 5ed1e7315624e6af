// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/result.h"
#include "fathom/diagnosis/search/suspect.h"

#include <vector>

namespace fathom {

// What data leave room for, of every effect of one parameter that `fit` does not have: the values
// that are not 95 % excluded, by the profile of the likelihood, linear in the other parameters,
// under the noise of the fit's residual. Effects at a time or of a frequency of the run have none.
// docs/diagnosis.md (11).
std::vector<ExclusionLimit> LimitsOf(const TrainingData& data,
                                     const StructureFit& fit,
                                     const std::vector<Suspect>& suspects);

}  // namespace fathom
