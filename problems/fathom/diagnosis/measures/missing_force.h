// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/started_model.h"
#include "fathom/diagnosis/measures/held_out.h"
#include "fathom/diagnosis/result.h"

#include <optional>
#include <vector>

namespace fathom {

// The force that the baseline misses: a force that wanders (Ornstein-Uhlenbeck), smoothed from the
// baseline's residual under the sensors' part of `noise`; beside it what the extended model adds,
// and what it may depend on. Of all segments of `data`, at their bins. docs/diagnosis.md (9).
MissingForce FindMissingForce(const TrainingData& data,
                              const StartedModel& baseline,
                              const StartedModel& extended,
                              const NoiseModel& noise,
                              const std::vector<Dof>& partners);

// Measured against both models' free runs over one segment; a run that diverged is left out.
ResidualTrace TraceOf(const MeasuredSegment& segment,
                      std::optional<FreeRun> before,
                      std::optional<FreeRun> after);

}  // namespace fathom
