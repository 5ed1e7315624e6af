// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/planning/command_block.h"
#include "fathom/simulate/coupled/coupled_inputs.h"

#include <cstddef>
#include <vector>

namespace fathom {

// An axis that is commanded.
struct WrenchAxis {
  Dof dof = Dof::kSurge;
  double force = 0.0;    // greatest each way [N] or [N m]
  double holding = 0.0;  // that keeps the vehicle where it is [N] or [N m]
};

// A part of a command of several axes: a block of each, all equally long.
struct WrenchBlock {
  int num_cells = 1;
  std::vector<CommandBlock> along;  // of each axis, in their order
};

// Every axis held.
WrenchBlock HeldBlock(const std::vector<WrenchAxis>& axes, int num_cells);

// One axis driven as by DrawBlock(), two, or all; the others held. `longest_hold`: of BlockRange.
WrenchBlock DrawWrenchBlock(const std::vector<WrenchAxis>& axes,
                            int num_cells,
                            int longest_hold,
                            RandomStream& random);

int NumCells(const std::vector<WrenchBlock>& blocks);

// The force along one of the axes in each cell.
std::vector<double> ForcesAlong(const std::vector<WrenchBlock>& blocks, std::size_t axis);

// As a command from t = 0 on; a cell lasts `hold` seconds. No force behind the last one.
CoupledCommand CommandOf(const std::vector<WrenchAxis>& axes,
                         const std::vector<WrenchBlock>& blocks,
                         double hold);

}  // namespace fathom
