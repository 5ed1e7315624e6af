// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/result.h"

namespace fathom {

// True if the baseline's residual is less than a thousandth of the motion (of the RMS speed [m/s]
// or [rad/s], and of the way made in a second): finer than any sensor shows it, and than the
// uncoupled model can be true. docs/diagnosis.md, "Verdict".
bool IsNegligible(const TrainingData& data, const StructureFit& baseline);

// RMS of a fit's residual of the velocity (of the displacement where there is none) over what of it
// scatters from sample to sample.
double WanderRatio(const TrainingData& data, const StructureFit& fit);

// Adds remarks on how far the data carry what is said of them: a baseline that they do not
// determine, poses alone, a command of one tone.
void AddRemarksOnTheEvidence(const TrainingData& data,
                             const StructureFit& baseline,
                             Diagnosis* diagnosis);

}  // namespace fathom
