// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/command_block.h"

#include "fathom/planning/wrench_block.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(CommandBlock, HasAForceForEachOfItsCells) {
  RandomStream random(3, "test");
  for (int i = 0; i < 200; ++i) {
    const int num_cells = 1 + i % 17;
    const CommandBlock block = DrawBlock({.force = 40.0, .longest_hold = 8}, num_cells, random);
    const std::vector<double> forces = ForcesOf(block);
    ASSERT_EQ(std::ssize(forces), num_cells);
    for (const double force : forces) EXPECT_LE(std::abs(force), 40.0);
  }
}

TEST(CommandBlock, IsWhatItsNameSays) {
  EXPECT_EQ(ForcesOf({.kind = BlockKind::kStep, .num_cells = 3, .level = -7.0}),
            (std::vector<double>{-7.0, -7.0, -7.0}));
  EXPECT_EQ(ForcesOf({.kind = BlockKind::kCoast, .num_cells = 2, .level = 5.0}),
            (std::vector<double>{0.0, 0.0}));

  // A telegraph holds each choice for its hold, and takes both.
  const std::vector<double> telegraph = ForcesOf(
      {.kind = BlockKind::kTelegraph, .num_cells = 60, .level = 5.0, .hold_cells = 3, .seed = 1});
  for (std::size_t i = 0; i < telegraph.size(); ++i) {
    EXPECT_EQ(std::abs(telegraph[i]), 5.0);
    EXPECT_EQ(telegraph[i], telegraph[i - i % 3]);
  }
  EXPECT_NE(*std::min_element(telegraph.begin(), telegraph.end()),
            *std::max_element(telegraph.begin(), telegraph.end()));

  // A multisine reaches its peak.
  double peak = 0.0;
  for (const double force : ForcesOf({.kind = BlockKind::kMultisine,
                            .num_cells = 50,
                            .level = 8.0,
                            .hold_cells = 2,
                            .seed = 4})) {
    peak = std::max(peak, std::abs(force));
  }
  EXPECT_DOUBLE_EQ(peak, 8.0);
}

TEST(CommandBlock, OneAfterTheOtherMakeACommand) {
  const std::vector<WrenchBlock> blocks = {
      {2, {{.kind = BlockKind::kStep, .num_cells = 2, .level = 3.0}}},
      {1, {{.kind = BlockKind::kCoast, .num_cells = 1}}}};
  const HeldCommand command = CommandOfCells(ForcesAlong(blocks, 0), 0.5);
  EXPECT_EQ(command.time, (std::vector<double>{0.0, 0.5, 1.0, 1.5}));
  EXPECT_EQ(command.value, (std::vector<double>{3.0, 3.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace fathom
