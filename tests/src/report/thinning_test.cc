// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::Contains;
using testing::ElementsAre;

TEST(ThinnedIndices, KeepsEverythingThatFits) {
  EXPECT_THAT(ThinnedIndices({{5.0, 5.0, 5.0}}, 3, 3), ElementsAre(0, 1, 2));
}

TEST(ThinnedIndices, KeepsThePeaksTheGapsAndTheEndsOfEveryCurve) {
  const std::size_t n = 100'000;
  std::vector<double> first(n);
  std::vector<double> second(n);
  for (std::size_t i = 0; i < n; ++i) first[i] = std::sin(1e-3 * static_cast<double>(i));
  first[31'234] = 7.0;
  second[77'777] = -3.0;
  second[50'001] = std::numeric_limits<double>::quiet_NaN();
  const auto kept = ThinnedIndices({first, second}, n, 2000);
  EXPECT_LE(kept.size(), 2000u);
  EXPECT_GT(kept.size(), 500u);
  EXPECT_TRUE(std::ranges::is_sorted(kept));
  EXPECT_EQ(std::ranges::adjacent_find(kept), kept.end());
  for (const std::size_t index : {0ul, 31'234ul, 77'777ul, 50'001ul, n - 1}) {
    EXPECT_THAT(kept, Contains(index));
  }
}

}  // namespace
}  // namespace fathom
