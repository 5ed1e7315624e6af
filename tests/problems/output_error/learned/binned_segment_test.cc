// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/binned_segment.h"

#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;

TEST(BinnedSegmentOf, AveragesWhatIsNotWildAndKnowsHowFewThatIs) {
  Segment segment;
  segment.time = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 2.0, 2.1, 3.0};
  segment.velocity.assign(segment.time.size(), 0.0);
  const std::vector<bool> is_wild = {false, false, true, false, false, false, false, false, true};
  const BinnedSegment bins = BinnedSegmentOf(segment, FittedOutput::kVelocity, 0.3, is_wild);
  EXPECT_THAT(bins.bin_of, ElementsAre(0, 0, -1, 1, 1, 1, 2, 2, -1));
  EXPECT_THAT(bins.count, ElementsAre(2.0, 3.0, 2.0));
  ASSERT_EQ(bins.size(), 3);
  EXPECT_DOUBLE_EQ(bins.samples[0].time, 0.05);
  EXPECT_DOUBLE_EQ(bins.samples[1].time, 0.4);
  EXPECT_DOUBLE_EQ(bins.samples[2].time, 2.05);
  // Against the usual two samples.
  EXPECT_DOUBLE_EQ(bins.samples[0].variance_factor, 1.0);
  EXPECT_DOUBLE_EQ(bins.samples[1].variance_factor, 2.0 / 3.0);
  EXPECT_EQ(bins.samples[0].channel, NoiseChannel::kVelocity);
}

TEST(BinnedSegmentOf, LeavesSamplesAloneThatStandFurtherApart) {
  Segment segment;
  segment.time = {0.0, 0.5, 1.0, 7.0};
  segment.position.assign(4, 0.0);
  const BinnedSegment bins =
      BinnedSegmentOf(segment, FittedOutput::kPosition, 0.01, std::vector<bool>(4, false));
  EXPECT_THAT(bins.bin_of, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(bins.samples[3].time, 7.0);
  EXPECT_EQ(bins.samples[3].channel, NoiseChannel::kDisplacement);
}

TEST(BinWidth, IsATwoThousandthOfTheDataAndHalfASecondAtMost) {
  std::vector<Segment> segments(2);
  segments[0].time = {0.0, 100.0};
  segments[1].time = {500.0, 800.0};
  EXPECT_DOUBLE_EQ(BinWidth(segments), 0.2);
  segments[1].time = {500.0, 50000.0};
  EXPECT_DOUBLE_EQ(BinWidth(segments), 0.5);
}

}  // namespace
}  // namespace fathom
