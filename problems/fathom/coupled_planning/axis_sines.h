// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_limits.h"
#include "fathom/coupled_planning/wrench_allocation.h"
#include "fathom/planning/wrench_block.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <optional>
#include <vector>

namespace fathom {

// The experiment that people drive otherwise: a sine on one axis after the other, each for its
// share of the time, the others held.
struct AxisSines {
  CoupledCommand command;
  std::vector<double> amplitude;  // of each axis [N] or [N m]
};

// The greatest that the model's own run keeps the limits under, and that the thrusters give where
// there are some, axis by axis in steps of a twentieth, of kSineFrequency.
AxisSines LargestAxisSines(const CoupledModel& model,
                           const std::vector<WrenchAxis>& axes,
                           const CoupledLimits& limits,
                           const std::optional<WrenchAllocation>& thrusters,
                           double duration);

}  // namespace fathom
