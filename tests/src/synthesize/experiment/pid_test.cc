// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/pid.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Pid, GivesTheForcesOfAHandCalculation) {
  Pid pid({.kp = 10.0, .ki = 4.0, .kd = 3.0, .limit = 1000.0}, 0.5);
  // e = 0.2; nothing to integrate or to differentiate yet.
  EXPECT_NEAR(pid.Force(1.0, 0.8), 2.0, 1e-12);
  // e = 0.6: I = 0.5 (0.2 + 0.6) 0.5 = 0.2, slope 0.8; 6 + 0.8 + 2.4.
  EXPECT_NEAR(pid.Force(1.0, 0.4), 9.2, 1e-12);
  // e = -0.1: I = 0.2 + 0.5 (0.6 - 0.1) 0.5 = 0.325, slope -1.4; -1 + 1.3 - 4.2.
  EXPECT_NEAR(pid.Force(0.5, 0.6), -3.9, 1e-12);
}

TEST(Pid, KeepsToItsLimitOnBothSides) {
  Pid pid({.kp = 10.0, .limit = 3.0}, 0.5);
  EXPECT_EQ(pid.Force(1.0, 0.0), 3.0);
  EXPECT_EQ(pid.Force(-1.0, 0.0), -3.0);
}

TEST(Pid, DoesNotWindUpAtItsLimit) {
  Pid pid({.kp = 1.0, .ki = 1.0, .limit = 2.0}, 1.0);
  // e = 5 for long: the force is at its limit from the start, so the integral stays 0.
  for (int i = 0; i < 100; ++i) EXPECT_EQ(pid.Force(5.0, 0.0), 2.0);
  // e = -0.5: I = 0.5 (5 - 0.5) = 2.25; -0.5 + 2.25. With the wound up integral it would be 2.
  EXPECT_NEAR(pid.Force(0.0, 0.5), 1.75, 1e-12);
}

}  // namespace
}  // namespace fathom
