// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/proposed_held_out.h"

#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(ProposedHeldOut, IsTheLastQuarter) {
  const std::vector<TimeInterval> whole = {{10.0, 110.0}};
  const TimeInterval held_out = ProposedHeldOut(whole);
  EXPECT_EQ(held_out.from, 85.0);
  EXPECT_EQ(held_out.to, 110.0);
}

// A quarter of 80 s: the last stretch of 8 s, and 12 s of the one before.
TEST(ProposedHeldOut, CountsNoTimeBetweenStretches) {
  const std::vector<TimeInterval> stretches = {{0.0, 30.0}, {100.0, 142.0}, {500.0, 508.0}};
  const TimeInterval held_out = ProposedHeldOut(stretches);
  EXPECT_DOUBLE_EQ(held_out.from, 130.0);
  EXPECT_EQ(held_out.to, 508.0);
}

}  // namespace
}  // namespace fathom
