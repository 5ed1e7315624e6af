// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/sentinel.h"

#include "values/noisy_motion.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Sentinel, IsAKnownNumberOrOneThatComesBack) {
  std::vector<double> values = NoisyMotionOf(500).value;
  values[77] = -32.768;
  auto sentinel = FindSentinel(values);
  ASSERT_TRUE(sentinel);
  EXPECT_EQ(sentinel->value, -32.768);
  EXPECT_EQ(sentinel->num_rows, 1u);
  EXPECT_EQ(sentinel->first, 77u);
  values[77] = values[200] = -7.0;
  sentinel = FindSentinel(values);
  ASSERT_TRUE(sentinel);
  EXPECT_EQ(sentinel->num_rows, 2u);
}

TEST(Sentinel, IsNotASingleWildSample) {
  std::vector<double> values = NoisyMotionOf(500).value;
  EXPECT_FALSE(FindSentinel(values));
  values[77] = -7.013;
  EXPECT_FALSE(FindSentinel(values));
  EXPECT_FALSE(FindSentinel(Rounded(NoisyMotionOf(500).value, 0.1)));
  EXPECT_FALSE(FindSentinel(std::vector<double>(10, 99.0)));
}

}  // namespace
}  // namespace fathom
