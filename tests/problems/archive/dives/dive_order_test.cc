// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/dive_order.h"

#include <limits>
#include <string_view>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;

TEST(ComesBefore, CountsDigitsAsNumbers) {
  EXPECT_TRUE(ComesBefore("dive 9", "dive 10"));
  EXPECT_FALSE(ComesBefore("dive 10", "dive 9"));
  EXPECT_TRUE(ComesBefore("a9b10", "a09b11"));
  EXPECT_TRUE(ComesBefore("a", "a1"));
  EXPECT_TRUE(ComesBefore("a1", "b0"));
  // Beyond every integer type.
  EXPECT_TRUE(ComesBefore("99999999999999999999999999999998", "99999999999999999999999999999999"));
}

TEST(ComesBefore, IsAStrictOrderOfDifferentNames) {
  for (const char* a : {"", "1", "01", "001", "1a", "a", "a1", "a01", "\xff", "é", "0", "00"}) {
    EXPECT_FALSE(ComesBefore(a, a)) << a;
    for (const char* b : {"", "1", "01", "001", "1a", "a", "a1", "a01", "\xff", "é", "0", "00"}) {
      if (std::string_view(a) == b) continue;
      EXPECT_NE(ComesBefore(a, b), ComesBefore(b, a)) << a << " " << b;
    }
  }
}

TEST(InOrder, GoesByStartWhereEveryDiveHasOne) {
  EXPECT_THAT(InOrder({{"a", 30.0}, {"b", 10.0}, {"c", 20.0}}), ElementsAre("b", "c", "a"));
  EXPECT_THAT(InOrder({{"b 10", 5.0}, {"b 9", 5.0}}), ElementsAre("b 9", "b 10"));
}

TEST(InOrder, GoesByNameWhereOneDiveHasNoStart) {
  EXPECT_THAT(
      InOrder({{"b 10", 1.0}, {"b 9", 2.0}, {"a", std::numeric_limits<double>::quiet_NaN()}}),
      ElementsAre("a", "b 9", "b 10"));
  EXPECT_THAT(InOrder({}), ElementsAre());
}

}  // namespace
}  // namespace fathom
