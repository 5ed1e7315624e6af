// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/given_block.h"

#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

bool IsHeld(const CommandBlock& along, const CommandBlock& held) {
  return along.kind == held.kind && along.level == held.level;
}

// False if every axis is held already.
bool LowerByAStep(const std::vector<WrenchAxis>& axes, WrenchBlock* block) {
  const WrenchBlock held = HeldBlock(axes, block->num_cells);
  bool is_lower = false;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    CommandBlock& along = block->along[k];
    if (IsHeld(along, held.along[k])) continue;
    is_lower = true;
    const double step = kLevelStep * axes[k].force;
    const double level = std::abs(along.level) - step;
    if (level > 0.5 * step) {
      along.level = std::copysign(level, along.level);
    } else {
      along = held.along[k];
    }
  }
  return is_lower;
}

}  // namespace

void LowerToThrusters(const std::vector<WrenchAxis>& axes,
                      const WrenchAllocation& thrusters,
                      WrenchBlock* block) {
  while (!thrusters.Gives(CommandOf(axes, {*block}, 1.0)) && LowerByAStep(axes, block)) {
  }
}

}  // namespace fathom
