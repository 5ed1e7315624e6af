// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/structure_fit.h"

namespace fathom {

// True if the baseline's residual is less than a thousandth of the motion (of the RMS speed [m/s]
// or [rad/s], and of the way made in a second): finer than any sensor shows it, and than the
// uncoupled model can be true. docs/diagnosis.md, "Verdict".
bool IsNegligible(const TrainingData& data, const StructureFit& baseline);

// Adds remarks on how far the data carry what is said of them: a baseline that they do not
// determine, poses alone, an error that wanders, a command of one tone.
void AddRemarksOnTheEvidence(const TrainingData& data,
                             const StructureFit& baseline,
                             Diagnosis* diagnosis);

}  // namespace fathom
