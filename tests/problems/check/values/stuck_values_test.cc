// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/values/stuck_values.h"

#include "values/noisy_motion.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(StuckValues, KeepOneValueWhileTheNextIsFarAway) {
  NoisyMotion motion = NoisyMotionOf(1000);
  for (int row = 51; row < 120; ++row) motion.value[row] = motion.value[50];
  const auto stuck = FindStuckValues(motion.time, motion.value);
  ASSERT_TRUE(stuck);
  EXPECT_EQ(stuck->longest.first, 50u);
  EXPECT_EQ(stuck->longest.last, 119u);
  EXPECT_EQ(stuck->num_rows, 70u);
}

// After whole periods the motion goes on where it stood: there is no jump, but noise never stops.
TEST(StuckValues, KeepOneValueWhereNoiseWouldMoveIt) {
  NoisyMotion motion = NoisyMotionOf(1000);
  for (int row = 51; row < 650; ++row) motion.value[row] = motion.value[650];
  const auto stuck = FindStuckValues(motion.time, motion.value);
  ASSERT_TRUE(stuck);
  EXPECT_EQ(stuck->num_rows, 600u);
}

TEST(StuckValues, AreNotThoseOfAVehicleAtRestOrOfACoarseSensor) {
  NoisyMotion motion = NoisyMotionOf(600);
  for (int row = 0; row < 300; ++row) motion.value[row] = 0.0;
  EXPECT_FALSE(FindStuckValues(motion.time, motion.value));
  motion = NoisyMotionOf(600);
  EXPECT_FALSE(FindStuckValues(motion.time, Rounded(motion.value, 0.1)));
  EXPECT_FALSE(FindStuckValues(motion.time, Rounded(motion.value, 0.5)));
  EXPECT_FALSE(FindStuckValues(motion.time, std::vector<double>(600, 0.3)));
}

}  // namespace
}  // namespace fathom
