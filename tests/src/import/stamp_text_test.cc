// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/stamp_text.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(StampText, ReadsDatesAndTimesOfDay) {
  // date -u -d '2026-05-03 14:30:05.25' +%s.%N
  constexpr double kInstant = 1777818605.25;
  for (const char* text : {"2026-05-03T14:30:05.25Z",
                           "2026-05-03 14:30:05.25",
                           "2026-05-03 14:30:05,25",
                           "2026/05/03 14:30:05.25",
                           "03.05.2026 14:30:05,25"}) {
    const auto stamp = ParseTextStamp(text);
    ASSERT_TRUE(stamp) << text;
    EXPECT_TRUE(stamp->has_date);
    EXPECT_EQ(stamp->seconds, kInstant) << text;
  }
  EXPECT_EQ(ParseTextStamp("14:30:05.25")->seconds, 52205.25);
  EXPECT_FALSE(ParseTextStamp("14:30:05.25")->has_date);
  EXPECT_EQ(ParseTextStamp("03.05.2026")->seconds, 1777766400.0);
}

TEST(StampText, TakesNothingElse) {
  for (const char* text :
       {"", "12", "1.5", "03/05/2026", "2026-13-01", "25:00:00", "12:3", "abc"}) {
    EXPECT_FALSE(ParseTextStamp(text)) << text;
  }
}

}  // namespace
}  // namespace fathom
