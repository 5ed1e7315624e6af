// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/tiny_as_zero.h"

#include <limits>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Of a number that the compiler does not know.
double Half(double of) {
  const volatile double unknown = of;
  return 0.5 * unknown;
}

TEST(TinyAsZero, HoldsWhileItLivesAndNoLonger) {
  const double smallest = std::numeric_limits<double>::min();
  EXPECT_GT(Half(smallest), 0.0);
#if defined(__SSE2__)
  {
    const TinyAsZero tiny_as_zero;
    EXPECT_EQ(Half(smallest), 0.0);
    EXPECT_GT(Half(4.0 * smallest), 0.0);
  }
#endif
  EXPECT_GT(Half(smallest), 0.0);
}

}  // namespace
}  // namespace fathom
