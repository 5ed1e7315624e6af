// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/unwrap.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Unwrap, FollowsAnAngleOverSeveralTurnsInBothDirections) {
  std::vector<double> wrapped, expected;
  for (int i = 0; i < 400; ++i) {
    expected.push_back(0.4 + 25.0 * std::sin(0.02 * i));
    wrapped.push_back(std::remainder(expected.back(), 2.0 * M_PI));
  }
  const auto unwrapped = Unwrap(wrapped);
  ASSERT_EQ(unwrapped.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(unwrapped[i], expected[i], 1e-12);
}

TEST(Unwrap, KeepsTheFirstAngleAndAnEmptyList) {
  EXPECT_TRUE(Unwrap({}).empty());
  EXPECT_EQ(Unwrap(std::vector<double>{7.0})[0], 7.0);
}

}  // namespace
}  // namespace fathom
