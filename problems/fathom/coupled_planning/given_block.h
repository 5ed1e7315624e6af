// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/wrench_allocation.h"
#include "fathom/planning/wrench_block.h"

#include <vector>

namespace fathom {

// Lowers the levels of the axes that a block drives, all by kLevelStep of their greatest force at a
// time, until the thrusters give it, or every axis is held.
void LowerToThrusters(const std::vector<WrenchAxis>& axes,
                      const WrenchAllocation& thrusters,
                      WrenchBlock* block);

}  // namespace fathom
