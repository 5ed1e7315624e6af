// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/with_interval.h"

#include <limits>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Half widths 1.96 * 0.0153 = 0.030, 1.96 * 0.077 = 0.151 and 1.96 * 5.9 = 11.6.
TEST(WithInterval, RoundsAtTheFirstDigitOfTheHalfWidthOrTheSecondBehindAOne) {
  EXPECT_EQ(WithInterval(0.4211, 0.0153, "s", -kInfinity, kInfinity), "0.42 s (0.39 to 0.45 s)");
  EXPECT_EQ(WithInterval(4.965, 0.077, "N", -kInfinity, kInfinity), "4.96 N (4.81 to 5.12 N)");
  EXPECT_EQ(WithInterval(852.5, 5.9, "kg", -kInfinity, kInfinity), "852 kg (841 to 864 kg)");
}

// 1.96 * 230 = 451.
TEST(WithInterval, RoundsBeforeThePoint) {
  EXPECT_EQ(WithInterval(12345.0, 230.0, "N", -kInfinity, kInfinity), "12300 N (11900 to 12800 N)");
}

TEST(WithInterval, EndsAtTheBounds) {
  EXPECT_EQ(WithInterval(0.02, 0.03, "s", 0.0, kInfinity), "0.02 s (0.00 to 0.08 s)");
  EXPECT_EQ(WithInterval(0.97, 0.03, "", 0.0, 0.98), "0.97 (0.91 to 0.98)");
}

TEST(WithInterval, HasNoMinusBeforeAZero) {
  EXPECT_EQ(WithInterval(-0.001, 0.03, "N", -kInfinity, kInfinity), "0.00 N (-0.06 to 0.06 N)");
}

TEST(WithInterval, IsTheNumberAloneWithoutADeviation) {
  EXPECT_EQ(WithInterval(0.42113, std::numeric_limits<double>::quiet_NaN(), "s", 0.0, 20.0),
            "0.4211 s");
  EXPECT_EQ(WithInterval(0.42113, 0.0, "", 0.0, 20.0), "0.4211");
}

TEST(WithInterval, WritesHugeNumbersWithAPowerOfTen) {
  EXPECT_EQ(WithInterval(3.21e7, 1.0e6, "N", -kInfinity, kInfinity),
            "3.21e+07 N (3.01e+07 to 3.41e+07 N)");
}

}  // namespace
}  // namespace fathom
