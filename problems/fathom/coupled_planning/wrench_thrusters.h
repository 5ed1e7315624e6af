// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"
#include "fathom/coupled_planning/wrench_allocation.h"
#include "fathom/planning/wrench_block.h"

#include <optional>
#include <vector>

namespace fathom {

// How the thrusters of the request's vehicle give a wrench on these axes; nothing where it has no
// vehicle. Throws InputError unless they drive each axis as far as the limits allow, and hold all
// axes at once.
std::optional<WrenchAllocation> WrenchThrusters(const CoupledPlanRequest& request,
                                                const std::vector<WrenchAxis>& axes);

}  // namespace fathom
