// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/short_number.h"

#include <limits>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(ShortNumber, HasNoExponentThatAPersonWouldTripOver) {
  EXPECT_EQ(ShortNumber(104.0, 2), "100");
  EXPECT_EQ(ShortNumber(-1234.0, 2), "-1200");
  EXPECT_EQ(ShortNumber(14.0, 1), "10");
}

TEST(ShortNumber, IsRoundedToItsDigits) {
  EXPECT_EQ(ShortNumber(0.1349, 2), "0.13");
  EXPECT_EQ(ShortNumber(2.0, 2), "2");
  EXPECT_EQ(ShortNumber(0.0, 1), "0");
  EXPECT_EQ(ShortNumber(std::numeric_limits<double>::infinity(), 2), "inf");
  EXPECT_EQ(ShortNumber(std::numeric_limits<double>::quiet_NaN(), 2), "nan");
}

}  // namespace
}  // namespace fathom
