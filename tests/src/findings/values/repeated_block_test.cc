// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/repeated_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

// A simulation without noise, of a periodic command.
TEST(RepeatedBlock, IsNotThePeriodOfASimulationUnlessACopyBreaksIt) {
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i)
    values.push_back(std::sin(2.0 * std::numbers::pi * (i % 200) / 200));
  EXPECT_FALSE(FindRepeatedBlock(values));
  for (int i = 0; i < 2000; ++i) values[i] += 1e-4 * i;
  EXPECT_FALSE(FindRepeatedBlock(values));
  std::copy_n(values.begin() + 130, 150, values.begin() + 1000);
  EXPECT_TRUE(FindRepeatedBlock(values));
}

}  // namespace
}  // namespace fathom
