// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/held_samples.h"

#include "values/noisy_motion.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

std::vector<double> Held(std::vector<double> values, std::size_t num_rows) {
  for (std::size_t row = 0; row < values.size(); ++row) values[row] = values[row - row % num_rows];
  return values;
}

TEST(HeldSamples, AreThoseOfASlowSensorWrittenFast) {
  const NoisyMotion motion = NoisyMotionOf(1000);
  const auto slow = FindHeldSamples(motion.time, Held(motion.value, 20));
  ASSERT_TRUE(slow);
  EXPECT_NEAR(slow->interval, 2.0, 1e-9);
  EXPECT_NEAR(slow->row_step, 0.1, 1e-9);
  const auto half = FindHeldSamples(motion.time, Held(motion.value, 2));
  ASSERT_TRUE(half);
  EXPECT_NEAR(half->interval, 0.2, 1e-9);
}

TEST(HeldSamples, AreNotThoseOfACoarseSensor) {
  const NoisyMotion motion = NoisyMotionOf(1000);
  EXPECT_FALSE(FindHeldSamples(motion.time, motion.value));
  for (const double resolution : {0.01, 0.05, 0.1, 0.2}) {
    EXPECT_FALSE(FindHeldSamples(motion.time, Rounded(motion.value, resolution))) << resolution;
  }
}

}  // namespace
}  // namespace fathom
