// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/random_stream.h"
#include "fathom/log/held_command.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace fathom {

// The kinds of command that people fly; docs/plan.md.
enum class BlockKind {
  kStep,       // one force, held
  kCoast,      // no force: the vehicle slows down by itself
  kTelegraph,  // one force or its opposite, changing at random at multiples of a hold
  kMultisine   // a sum of sines, held over each cell
};

// "step", "coast", "telegraph" or "multisine".
std::string_view Name(BlockKind kind);

// A part of a command: some cells, each as long as the shortest hold, with one force in each.
struct CommandBlock {
  BlockKind kind = BlockKind::kCoast;
  int num_cells = 1;
  double level = 0.0;      // of a step, with its sign; else the peak, above 0 [N] or [N m]
  int hold_cells = 1;      // of a telegraph: between two choices; of a multisine: its fastest half
                           // period
  std::uint64_t seed = 0;  // of a telegraph's choices and a multisine's phases
};

// From what blocks are drawn.
struct BlockRange {
  double force = 0.0;    // greatest [N] or [N m]
  int longest_hold = 1;  // of a telegraph, and half the slowest period of a multisine [cells]
};

// Levels are multiples of this share of the greatest force: nobody flies 37.218 N.
inline constexpr double kLevelStep = 0.05;

// A block of so many cells.
CommandBlock DrawBlock(const BlockRange& range, int num_cells, RandomStream& random);

// The force in each of its cells.
std::vector<double> ForcesOf(const CommandBlock& block);

// Forces of cells as a command from t = 0 on; a cell lasts `hold` seconds. No force behind the last
// one.
HeldCommand CommandOfCells(const std::vector<double>& forces, double hold);

}  // namespace fathom
