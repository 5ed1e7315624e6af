// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/chi_square.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// From tables: the values that chi-square reaches with a probability of 5 % and of 1 %.
TEST(ChiSquareTail, AgreesWithTables) {
  EXPECT_NEAR(ChiSquareTail(3.841459, 1), 0.05, 1e-7);
  EXPECT_NEAR(ChiSquareTail(5.991465, 2), 0.05, 1e-7);
  EXPECT_NEAR(ChiSquareTail(11.344867, 3), 0.01, 1e-7);
  EXPECT_NEAR(ChiSquareTail(21.026070, 12), 0.05, 1e-7);
  EXPECT_EQ(ChiSquareTail(3.0, 0), 1.0);
}

}  // namespace
}  // namespace fathom
