// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/run_start.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

TEST(InitialVelocity, IsSmoothedWhereTheSegmentKnowsHow) {
  Segment segment;
  segment.velocity = {0.5, 2.0, 2.0};
  EXPECT_EQ(InitialVelocity(segment), 0.5);
  segment.initial_velocity = 0.4;
  EXPECT_EQ(InitialVelocity(segment), 0.4);
}

TEST(WayAlong, IsTheIntegralOfTheSpeedFromASampleOn) {
  const std::vector<double> time = {0.0, 1.0, 3.0, 4.0}, speed = {9.0, 1.0, 2.0, 4.0};
  EXPECT_THAT(WayAlong(time, speed, 1), ::testing::ElementsAre(0.0, 0.0, 3.0, 6.0));
}

TEST(PositionAt, LiesBetweenThePosesAndIsZeroWithout) {
  Log log;
  EXPECT_EQ(PositionAt(log, Dof::kHeave, 1.0), 0.0);
  log.pose =
      Stream{{0.0, 1.0, 2.0},
             {"x", "y", "z", "qx", "qy", "qz", "qw"},
             {{0, 0, 0}, {0, 0, 0}, {3.0, 4.0, 6.0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1, 1}}};
  EXPECT_NEAR(PositionAt(log, Dof::kHeave, 1.25), 4.5, 1e-12);
  EXPECT_NEAR(PositionAt(log, Dof::kHeave, -7.0), 3.0, 1e-12);
  EXPECT_NEAR(PositionAt(log, Dof::kHeave, 9.0), 6.0, 1e-12);
}

}  // namespace
}  // namespace fathom
