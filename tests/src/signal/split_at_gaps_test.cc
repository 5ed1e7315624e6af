// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/split_at_gaps.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

void ExpectRange(
    const SampleRange& range, size_t begin, size_t end, bool held_out, bool after_gap) {
  EXPECT_EQ(range.begin, begin);
  EXPECT_EQ(range.end, end);
  EXPECT_EQ(range.is_held_out, held_out);
  EXPECT_EQ(range.is_after_gap, after_gap);
}

TEST(SplitAtGaps, CutsAtASilenceOfOverThirtySecondsAndNotAtThirty) {
  const std::vector<double> time = {0.0, 1.0, 31.0, 61.5, 62.0};
  const auto ranges = SplitAtGaps(time);
  ASSERT_EQ(ranges.size(), 2u);
  ExpectRange(ranges[0], 0, 3, false, false);
  ExpectRange(ranges[1], 3, 5, false, true);
}

TEST(SplitAtGaps, CutsWhereAHeldOutIntervalBeginsAndEnds) {
  const std::vector<double> time = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  const std::vector<TimeInterval> held_out = {{1.5, 4.0}};  // its end is outside
  const auto ranges = SplitAtGaps(time, held_out);
  ASSERT_EQ(ranges.size(), 3u);
  ExpectRange(ranges[0], 0, 2, false, false);
  ExpectRange(ranges[1], 2, 4, true, false);
  ExpectRange(ranges[2], 4, 6, false, false);
}

TEST(SplitAtGaps, CutsInsideAHeldOutIntervalToo) {
  const std::vector<double> time = {0.0, 50.0};
  const std::vector<TimeInterval> held_out = {{-1.0, 60.0}};
  const auto ranges = SplitAtGaps(time, held_out);
  ASSERT_EQ(ranges.size(), 2u);
  ExpectRange(ranges[0], 0, 1, true, false);
  ExpectRange(ranges[1], 1, 2, true, true);
}

TEST(SplitAtGaps, LooksAtNothingBeforeItsFirstSample) {
  const std::vector<double> time = {0.0, 100.0, 101.0};
  const auto ranges = SplitAtGaps(time, {}, 1);
  ASSERT_EQ(ranges.size(), 1u);
  ExpectRange(ranges[0], 1, 3, false, false);
  EXPECT_TRUE(SplitAtGaps(time, {}, 3).empty());
}

TEST(WithoutShort, CountsWhatItLeavesOut) {
  const std::vector<SampleRange> ranges = {{0, 3}, {3, 13}, {13, 17}, {17, 27}};
  const LongRanges kept = WithoutShort(ranges, 10);
  ASSERT_EQ(kept.ranges.size(), 2u);
  EXPECT_EQ(kept.ranges[1].begin, 17u);
  EXPECT_EQ(kept.num_short, 2u);
  EXPECT_EQ(kept.num_samples_in_short, 7u);
}

}  // namespace
}  // namespace fathom
