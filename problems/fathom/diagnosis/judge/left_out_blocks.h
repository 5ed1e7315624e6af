// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/judge/held_out.h"

namespace fathom {

// For logs that hold nothing out: with a quarter of the data left out at a time, the baseline by
// output error (`baseline` itself where that finds none) and the extended structure by its
// criterion are fitted anew and run freely over that quarter. Nothing if the data are too few.
Scored LeaveBlocksOut(const TrainingData& data,
                      const ExtendedModel& baseline,
                      const StructureFit& extended,
                      Criterion criterion);

}  // namespace fathom
