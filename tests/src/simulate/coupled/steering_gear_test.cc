// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/steering_gear.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// The mean over many small pieces of the step.
TEST(TurnRudder, IsTheMeanOfTheRamp) {
  struct Case {
    double angle, order, rate, wait;
  };
  for (const Case& c : {Case{0.1, -0.3, 0.5, 0.0},
                        Case{0.1, -0.3, 7.0, 0.03},
                        Case{-0.2, 0.15, 2.0, 0.07},
                        Case{0.2, 0.2, 1.0, 0.0}}) {
    const double step = 0.1;
    const int pieces = 100000;
    double mean = 0.0, angle = 0.0;
    for (int k = 0; k < pieces; ++k) {
      const double turned = c.rate * std::max(step * (k + 0.5) / pieces - c.wait, 0.0);
      angle = c.angle + std::clamp(c.order - c.angle, -turned, turned);
      mean += angle / pieces;
    }
    const GearStep gear = TurnRudder(c.angle, c.order, c.rate, c.wait, step);
    EXPECT_NEAR(gear.mean, mean, 1e-5);
    EXPECT_NEAR(gear.end, angle, 1e-4);
  }
}

TEST(TurnRudder, TurnsAtOnceWithoutALimit) {
  const GearStep gear = TurnRudder(0.1, -0.3, std::numeric_limits<double>::infinity(), 0.025, 0.1);
  EXPECT_DOUBLE_EQ(gear.mean, 0.25 * 0.1 - 0.75 * 0.3);
  EXPECT_DOUBLE_EQ(gear.end, -0.3);
}

}  // namespace
}  // namespace fathom
