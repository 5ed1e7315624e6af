// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"
#include "fathom/diagnosis/fit/structure_fit.h"

namespace fathom {

// The likeliest that is found on either side of a fit under a learned noise. An effect whose
// response changes shape with its size, such as a delay of a command that comes in steps, has a
// minimum of the error in every step, and a search ends in the nearest. The covariance is that of
// all minima about the likeliest one, each by its likelihood, docs/diagnosis.md (3).
StructureFit LikeliestMinimum(const TrainingData& data, StructureFit fit);

}  // namespace fathom
