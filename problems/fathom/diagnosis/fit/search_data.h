// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"

#include <vector>

namespace fathom {

// The segments of `data`, Thinned() as coarsely as nobody sees: over half a bin where that
// changes a run of `fit`, a model of these data, by less than its noise lets see; else over a tenth
// of a second. docs/diagnosis.md (2).
std::vector<MeasuredSegment> SearchDataOf(const TrainingData& data, const StructureFit& fit);

}  // namespace fathom
