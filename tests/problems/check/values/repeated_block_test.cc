// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/values/repeated_block.h"

#include <algorithm>

#include "values/noisy_motion.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(RepeatedBlock, IsFoundWhereverItLies) {
  for (const std::size_t first : {0u, 13u, 50u, 201u}) {
    for (const std::size_t second : {403u, 450u, 877u}) {
      std::vector<double> values = NoisyMotionOf(1000).value;
      std::copy_n(values.begin() + first, 120, values.begin() + second);
      const auto block = FindRepeatedBlock(values);
      ASSERT_TRUE(block) << first << " " << second;
      EXPECT_EQ(block->first, first);
      EXPECT_EQ(block->second, second);
      EXPECT_EQ(block->num_rows, 120u);
    }
  }
}

TEST(RepeatedBlock, IsNotWhereNothingMovesOrTheSensorIsCoarse) {
  EXPECT_FALSE(FindRepeatedBlock(NoisyMotionOf(5000).value));
  EXPECT_FALSE(FindRepeatedBlock(std::vector<double>(1000, 0.0)));
  EXPECT_FALSE(FindRepeatedBlock(Rounded(NoisyMotionOf(20000).value, 0.01)));
  EXPECT_FALSE(FindRepeatedBlock(Rounded(NoisyMotionOf(20000).value, 0.1)));
}

}  // namespace
}  // namespace fathom
