// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "placebo.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// The first of the 200 trials of placebo_trials, which prints them all.
class Placebo : public testing::TestWithParam<int> {};

TEST_P(Placebo, IsNeverNamed) {
  for (int seed = GetParam(); seed < GetParam() + 4; ++seed) {
    const PlaceboResult result = TryPlacebo(seed);
    EXPECT_TRUE(result.is_offered) << seed;
    EXPECT_FALSE(result.is_named) << seed << ": " << result.text;
  }
}

INSTANTIATE_TEST_SUITE_P(FirstTrials, Placebo, testing::Values(0, 4, 8, 12, 16));

}  // namespace
}  // namespace fathom
