// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/quantile.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Quantile, IsTheValueAtItsPlaceInTheOrder) {
  const std::vector<double> values = {5.0, 1.0, 4.0, 2.0, 3.0};
  EXPECT_EQ(Quantile(values, 0.0), 1.0);
  EXPECT_EQ(Quantile(values, 0.5), 3.0);
  EXPECT_EQ(Quantile(values, 0.9), 4.0);
  EXPECT_EQ(Quantile(values, 1.0), 5.0);
  EXPECT_EQ(Quantile({7.0}, 0.3), 7.0);
}

}  // namespace
}  // namespace fathom
