// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/lost_values.h"

#include "values/noisy_motion.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(LostValues, AreZerosAmongFastMotion) {
  std::vector<double> values = NoisyMotionOf(1000).value;
  // The swing is at 0.5 m/s around row 50, 250, ...
  for (int row = 40; row < 60; ++row) values[row] = 0.0;
  values[250] = 0.0;
  const auto lost = FindLostValues(values);
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->num_rows, 21u);
  EXPECT_EQ(lost->first, 40u);
}

TEST(LostValues, AreFoundWhereEveryFifthRowIsLost) {
  std::vector<double> values = NoisyMotionOf(1000).value;
  for (std::size_t row = 0; row < values.size(); row += 5) values[row] = 0.0;
  const auto lost = FindLostValues(values);
  ASSERT_TRUE(lost);
  EXPECT_GT(lost->num_rows, 100u);  // of 200, those far from a reversal
}

TEST(LostValues, AreNoZerosOfAVehicleThatComesToRest) {
  std::vector<double> values(300, 0.0);
  for (int row = 0; row < 100; ++row) values[row] = 0.5 * (1.0 - 0.01 * row);
  for (int row = 200; row < 300; ++row) values[row] = 0.005 * (row - 199);
  EXPECT_FALSE(FindLostValues(values));
  EXPECT_FALSE(FindLostValues(Rounded(NoisyMotionOf(1000).value, 0.05)));
  EXPECT_FALSE(FindLostValues(std::vector<double>(100, 0.0)));
}

}  // namespace
}  // namespace fathom
