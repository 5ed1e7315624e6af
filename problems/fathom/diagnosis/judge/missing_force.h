// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/judge/held_out.h"
#include "fathom/diagnosis/result.h"

#include <optional>
#include <vector>

namespace fathom {

// The force that the baseline misses: a force that wanders (Ornstein-Uhlenbeck), smoothed from the
// baseline's residual under sensor noise alone; beside it what the extended model adds, and what it
// may depend on. Of all records of `data`, at their bins. docs/diagnosis.md (9).
MissingForce FindMissingForce(const TrainingData& data,
                              const StructureFit& baseline,
                              const StructureFit& extended,
                              const std::vector<Dof>& partners);

// Measured against both models' free runs over one record; a run that diverged is left out.
ResidualTrace TraceOf(const Record& record,
                      std::optional<FreeRun> before,
                      std::optional<FreeRun> after);

}  // namespace fathom
