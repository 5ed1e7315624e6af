// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/command_judge.h"
#include "fathom/planning/wrench_block.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace fathom {

struct CommandTask {
  std::vector<WrenchAxis> axes;  // one at least
  double hold = 1.0;             // of one force: the period of the command [s]
  double duration = 0.0;         // [s]

  // A judge by the limits of motion times `share`. Each start has one of its own.
  std::function<std::unique_ptr<CommandJudge>(double share)> judge;

  // Whether enough of other models keep the limits. Several threads ask at once.
  std::function<bool(const std::vector<WrenchBlock>& blocks)> is_kept_by_others;

  int num_starts = 4;          // at least 1
  int drawn_per_block = 40;    // of which the best is taken
  int num_moves_of_start = 0;  // changes that are tried of each start,
  int num_moves = 0;           // and of the best one
  std::uint64_t seed = 1;
};

struct FoundCommand {
  std::vector<WrenchBlock> blocks;  // empty: no command keeps the limits
  double value = -std::numeric_limits<double>::infinity();
};

// The sequence of blocks of greatest worth that keeps the limits: built block by block, each the
// best of several drawn; then improved by exchanging a block, its level, its length or its place,
// as long as the worth grows; from several starts, of which the best is improved further. Where
// others do not keep the limits, those of motion are narrowed. docs/plan.md, "The search". Depends
// on nothing but the task: the same one gives the same command to the bit.
FoundCommand SearchCommand(const CommandTask& task);

}  // namespace fathom
