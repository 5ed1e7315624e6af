// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/robust_std.h"

#include "fathom/base/random_stream.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(RobustStd, IsThatOfNormalErrorsWhateverAFewAre) {
  RandomStream random(3, "robust_std");
  std::vector<double> sizes;
  for (int i = 0; i < 40000; ++i) sizes.push_back(std::abs(2.5 * random.Normal()));
  // The median of so many scatters by 0.6 %.
  EXPECT_NEAR(RobustStd(sizes), 2.5, 0.05);
  for (int i = 0; i < 200; ++i) sizes[i] = 1e6;
  EXPECT_NEAR(RobustStd(sizes), 2.5, 0.05);
}

}  // namespace
}  // namespace fathom
