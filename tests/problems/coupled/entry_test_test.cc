// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/entry_test.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

EntryTest TestOf(double z, std::vector<double> likeness) {
  EntryTest test;
  test.z = z;
  test.likeness = std::move(likeness);
  return test;
}

// The 95 % quantile of chi-squared with three degrees of freedom is 7.815.
TEST(JointPValue, IsThatOfChiSquared) {
  const double z = std::sqrt(7.8147 / 3.0);
  const std::vector<EntryTest> tests = {
      TestOf(z, {1.0, 0.0, 0.0}), TestOf(-z, {0.0, 1.0, 0.0}), TestOf(z, {0.0, 0.0, 1.0})};
  EXPECT_NEAR(JointPValue(tests), 0.05, 1e-5);
}

// Two at 1.96 that are one and the same in the data say it once.
TEST(JointPValue, CountsWhatIsAlikeOnce) {
  const std::vector<EntryTest> tests = {TestOf(1.959964, {1.0, 1.0}), TestOf(1.959964, {1.0, 1.0})};
  EXPECT_NEAR(JointPValue(tests), 0.05, 1e-5);
}

// Of half a likeness: z' inverse((1, 0.5), (0.5, 1)) z = 4 for z = (sqrt 3, sqrt 3).
TEST(JointPValue, AllowsForLikeness) {
  const std::vector<EntryTest> tests = {TestOf(std::sqrt(3.0), {1.0, 0.5}),
                                        TestOf(std::sqrt(3.0), {0.5, 1.0})};
  EXPECT_NEAR(JointPValue(tests), std::exp(-2.0), 1e-9);
}

TEST(JointPValue, IsOneOfNothing) { EXPECT_EQ(JointPValue({}), 1.0); }

}  // namespace
}  // namespace fathom
