// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/number.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(ParseFiniteNumber, ReadsDecimalNumbersToTheNearestDouble) {
  EXPECT_EQ(ParseFiniteNumber("-1.5"), -1.5);
  EXPECT_EQ(ParseFiniteNumber(".5"), 0.5);
  EXPECT_EQ(ParseFiniteNumber("2e-3"), 0.002);
  EXPECT_EQ(ParseFiniteNumber("1433350639.315205"), 1433350639.315205);
  EXPECT_EQ(ParseFiniteNumber("0.1"), 0.1);
}

TEST(ParseFiniteNumber, GivesNothingForAnythingElse) {
  for (const char* text : {"",
                           " 1",
                           "1 ",
                           "+1",
                           "nan",
                           "inf",
                           "-inf",
                           "1e999",
                           "1,5",
                           "0x10",
                           "--1",
                           "1.2.3",
                           "e5",
                           "NaN",
                           "infinity"}) {
    EXPECT_FALSE(ParseFiniteNumber(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace fathom
