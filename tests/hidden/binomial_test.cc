// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "binomial.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom::hidden {
namespace {

TEST(Binomial, CountsAtMost) {
  // Three fair coins: 1/8, 4/8, 7/8, 1.
  EXPECT_NEAR(AtMost(0, 3, 0.5), 0.125, 1e-12);
  EXPECT_NEAR(AtMost(1, 3, 0.5), 0.5, 1e-12);
  EXPECT_NEAR(AtMost(2, 3, 0.5), 0.875, 1e-12);
  EXPECT_EQ(AtMost(3, 3, 0.5), 1.0);
}

TEST(Binomial, HasTheIntervalsOfClopperAndPearson) {
  // No success of n: 1 - 0.025^(1/n). All of n: the mirror image.
  const Interval none = ClopperPearson(0, 120);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 1.0 - std::pow(0.025, 1.0 / 120.0), 1e-9);
  const Interval all = ClopperPearson(120, 120);
  EXPECT_NEAR(all.low, std::pow(0.025, 1.0 / 120.0), 1e-9);
  EXPECT_EQ(all.high, 1.0);
  // One of two: (x^2 = 0.025) and its mirror image.
  const Interval half = ClopperPearson(1, 2);
  EXPECT_NEAR(half.low, 1.0 - std::sqrt(0.975), 1e-9);
  EXPECT_NEAR(half.high, std::sqrt(0.975), 1e-9);
  EXPECT_EQ(ClopperPearson(0, 0).high, 1.0);
}

TEST(Binomial, LeavesSlackForSmallSamples) {
  // Three fair coins: fewer than 1 happens with 1/8, fewer than 2 with 1/2.
  EXPECT_EQ(FewestExpected(3, 0.5, 0.1), 0);
  EXPECT_EQ(FewestExpected(3, 0.5, 0.2), 1);
  EXPECT_EQ(FewestExpected(3, 0.5, 0.6), 2);
  EXPECT_EQ(MostExpected(3, 0.5, 0.1), 3);
  EXPECT_EQ(MostExpected(3, 0.5, 0.2), 2);
}

}  // namespace
}  // namespace fathom::hidden
