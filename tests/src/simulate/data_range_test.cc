// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/data_range.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Stamps 10 and 12 s, a command at 9, 11 and 13 s.
Segment ExampleSegment() {
  Segment segment;
  segment.time = {10.0, 12.0};
  segment.velocity = {0.25, -0.5};
  segment.command = {{9.0, 11.0, 13.0}, {7.0, -3.0, 90.0}};
  return segment;
}

TEST(RangeOf, IsOfTheSpeedsAndTheForcesThatHeldMeanwhile) {
  const auto range = RangeOf(std::vector<Segment>{ExampleSegment()});
  ASSERT_TRUE(range);
  EXPECT_EQ(range->speed.low, -0.5);
  EXPECT_EQ(range->speed.high, 0.25);
  EXPECT_EQ(range->force.low, -3.0);
  EXPECT_EQ(range->force.high, 7.0);  // commanded before the first stamp; 90 N after the last
}

TEST(RangeOf, CountsTheForceBeforeTheFirstCommandAsNone) {
  Segment segment = ExampleSegment();
  segment.command = {{11.0}, {5.0}};
  EXPECT_EQ(RangeOf(std::vector<Segment>{segment})->force.low, 0.0);
}

TEST(RangeOf, IsOfAllSegmentsTogether) {
  Segment second = ExampleSegment();
  second.velocity = {0.75, std::nan("")};
  const auto range = RangeOf(std::vector<Segment>{ExampleSegment(), second});
  EXPECT_EQ(range->speed.low, -0.5);
  EXPECT_EQ(range->speed.high, 0.75);
}

TEST(RangeOf, IsNothingWhereNothingWasMeasured) {
  EXPECT_FALSE(RangeOf({}));
  Segment segment = ExampleSegment();
  segment.velocity = {std::nan(""), std::nan("")};
  EXPECT_FALSE(RangeOf(std::vector<Segment>{segment}));
}

}  // namespace
}  // namespace fathom
