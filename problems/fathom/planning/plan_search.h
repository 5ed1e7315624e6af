// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/command_block.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/vehicle/extended_model.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace fathom {

// How much a command is worth; minus infinity: nothing. Without stamps: what no command is worth.
using CommandMeasure =
    std::function<double(const HeldCommand& command, std::span<const double> stamps)>;

struct CommandTask {
  Dof dof = Dof::kSurge;
  PlanLimits limits;
  double duration = 0.0;              // [s]
  double period = 0.1;                // of the stamps at which motion is looked at [s]
  double holding_force = 0.0;         // that keeps the vehicle where it is [N] or [N m]
  std::vector<ExtendedModel> models;  // that must keep the limits, all of them: one at least
  std::function<bool(const HeldCommand& command)> is_kept_by_others;  // by enough of other models
  CommandMeasure measure;
  int num_starts = 4;        // at least 1
  int drawn_per_block = 40;  // of which the best is taken
  int num_moves = 2000;      // changes tried of the best start, and of all starts together
  std::uint64_t seed = 1;
};

struct FoundCommand {
  std::vector<CommandBlock> blocks;  // empty: no command keeps the limits
  double value = -std::numeric_limits<double>::infinity();
};

// The sequence of blocks of greatest measure that keeps the limits: built block by block, each the
// best of several drawn; then improved by exchanging a block, its level, its length or its place,
// as long as the measure grows; from several starts, of which the best is improved further. Where
// others do not keep the limits, those of speed and distance are narrowed.
// docs/plan.md, "The search". Depends on nothing but the task: the same one gives the same command
// to the bit.
FoundCommand SearchCommand(const CommandTask& task);

}  // namespace fathom
