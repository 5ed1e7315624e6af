// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/stuck_values.h"

#include <cmath>
#include <vector>

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

// A speed of a simulation, without noise, written with six digits: each step of the force takes it
// towards a steady value with a time constant of 0.3 s, and it stays there.
TEST(StuckValues, AreNotThoseOfAMotionThatComesToRestWithoutNoise) {
  std::vector<double> time, value;
  double v = 0.0, steady = 0.0;
  for (int i = 0; i < 2000; ++i) {
    if (i % 150 == 100) steady = 0.2 + 0.1 * ((i / 150 * 7) % 5);
    time.push_back(0.1 * i);
    value.push_back(std::round(v * 1e6) / 1e6);
    v += (steady - v) * (1.0 - std::exp(-0.1 / 0.3));
  }
  EXPECT_FALSE(FindStuckValues(time, value));
}

}  // namespace
}  // namespace fathom
