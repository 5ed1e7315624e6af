// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/median.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Median, IsTheMiddleValueInOrder) {
  EXPECT_EQ(Median({3.0}), 3.0);
  EXPECT_EQ(Median({9.0, -1.0, 4.0}), 4.0);
  EXPECT_EQ(Median({5.0, 1.0, 1e9, 2.0, 3.0}), 3.0);
}

TEST(Median, OfAnEvenNumberIsTheUpperOfTheMiddleTwo) {
  EXPECT_EQ(Median({4.0, 1.0, 3.0, 2.0}), 3.0);
}

TEST(MedianStep, IsNotMovedBySilences) {
  const std::vector<double> time = {10.0, 10.5, 11.0, 60.0, 60.5, 61.0};
  EXPECT_EQ(MedianStep(time), 0.5);
}

}  // namespace
}  // namespace fathom
