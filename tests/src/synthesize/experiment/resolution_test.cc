// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/resolution.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(RoundTo, GivesTheDoubleNearestToTheDecimal) {
  EXPECT_EQ(RoundTo(0.29996, 0.0001), 0.3);
  EXPECT_EQ(RoundTo(-52.8949, 0.01), -52.89);
  EXPECT_EQ(RoundTo(1433350623.6771312, 1e-6), 1433350623.677131);
}

TEST(RoundTo, TakesStepsThatDoNotDivideOne) {
  EXPECT_EQ(RoundTo(0.8, 0.75), 0.75);
  EXPECT_EQ(RoundTo(17.0, 5.0), 15.0);
}

TEST(RoundTo, LeavesTheValueAtResolution0) { EXPECT_EQ(RoundTo(0.123456789, 0.0), 0.123456789); }

TEST(RoundTo, HasNoNegativeZero) { EXPECT_FALSE(std::signbit(RoundTo(-1e-5, 0.01))); }

}  // namespace
}  // namespace fathom
