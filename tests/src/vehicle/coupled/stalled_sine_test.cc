// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/stalled_sine.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kLimit = 0.3;

TEST(StalledSine, IsTheSineBelowAndTheLimitBeyond) {
  EXPECT_EQ(StalledSineOf(0.26, kLimit).value, 0.26);
  EXPECT_EQ(StalledSineOf(-0.26, kLimit).value, -0.26);
  EXPECT_EQ(StalledSineOf(0.34, kLimit).value, kLimit);
  EXPECT_EQ(StalledSineOf(-0.9, kLimit).value, -kLimit);
}

// Half way the slope is a half, and a quarter of half the bend is lost.
TEST(StalledSine, BendsBetween) {
  const StalledSine half = StalledSineOf(kLimit, kLimit);
  EXPECT_NEAR(half.by_sine, 0.5, 1e-12);
  EXPECT_NEAR(half.value, kLimit - 0.25 * 0.1 * kLimit, 1e-12);
}

TEST(StalledSine, HasTheDerivativesOfDifferences) {
  constexpr double kStep = 1e-6;
  for (const double sine : {-0.5, -0.31, -0.28, -0.2, 0.1, 0.275, 0.305, 0.325, 0.4}) {
    const StalledSine at = StalledSineOf(sine, kLimit);
    const auto slope = [&](double by_sine, double by_limit) {
      return (StalledSineOf(sine + by_sine, kLimit + by_limit).value -
              StalledSineOf(sine - by_sine, kLimit - by_limit).value) /
             (2.0 * kStep);
    };
    EXPECT_NEAR(at.by_sine, slope(kStep, 0.0), 1e-8) << sine;
    EXPECT_NEAR(at.by_limit, slope(0.0, kStep), 1e-8) << sine;
  }
}

// Neither value nor slope jumps where a piece ends.
TEST(StalledSine, GoesOnSmoothly) {
  constexpr double kBit = 1e-9;
  for (const double end : {0.27, 0.33}) {
    const StalledSine below = StalledSineOf(end - kBit, kLimit);
    const StalledSine above = StalledSineOf(end + kBit, kLimit);
    EXPECT_NEAR(below.value, above.value, 3.0 * kBit);
    EXPECT_NEAR(below.by_sine, above.by_sine, 1e-6);
    EXPECT_NEAR(below.by_limit, above.by_limit, 1e-6);
  }
}

}  // namespace
}  // namespace fathom
