// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/utc_time.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// The numbers are those of `date -u -d <text> +%s`.
TEST(UtcTime, ReadsInstants) {
  EXPECT_EQ(ParseUtc("1970-01-01"), 0.0);
  EXPECT_EQ(ParseUtc("2026-05-03T14:30:05Z"), 1777818605.0);
  EXPECT_EQ(ParseUtc("2026-05-03 14:30:05.25"), 1777818605.25);
  EXPECT_EQ(ParseUtc("2024-02-29T23:59Z"), 1709251140.0);
  EXPECT_EQ(ParseUtc("1969-12-31T23:59:59Z"), -1.0);
}

TEST(UtcTime, RefusesWhatIsNone) {
  for (const char* text : {"",
                           "2026",
                           "2026-13-01",
                           "2026-02-29",
                           "2026-5-3",
                           "03.05.2026",
                           "2026-05-03T",
                           "2026-05-03T24:00Z",
                           "2026-05-03T14:30:05+02:00",
                           "2026-05-03T14:30:05Zx",
                           "2026-05-03T14:30:05."}) {
    EXPECT_FALSE(ParseUtc(text)) << text;
  }
}

TEST(UtcTime, WritesWhatItReads) {
  EXPECT_EQ(FormatUtc(1777818605.0), "2026-05-03T14:30:05Z");
  EXPECT_EQ(FormatUtc(1777818605.25), "2026-05-03T14:30:05.250000Z");
  EXPECT_EQ(ParseUtc("2026-05-03T14:30:05.250000Z"), 1777818605.25);
  EXPECT_EQ(FormatUtc(-1.0), "1969-12-31T23:59:59Z");
  EXPECT_EQ(FormatUtc(1e300), "");
}

}  // namespace
}  // namespace fathom
