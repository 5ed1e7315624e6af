// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/recent_scatter.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// An estimate that comes to rest while it swings.
ParameterVector WalkAt(int k) {
  const double t = 0.01 * k;
  return {40.0 + 60.0 * std::exp(-0.3 * t) + 0.5 * std::sin(7.0 * t),
          30.0 - 20.0 * std::exp(-0.2 * t),
          5.0 + std::cos(3.0 * t),
          -1.0 + 1e-3 * t};
}

// Written out over all that came, from the sample `begin` on.
ParameterVector StdWrittenOut(int begin, int num) {
  ParameterVector sum = ParameterVector::Zero();
  for (int k = begin; k < num; ++k) sum += (WalkAt(k) - WalkAt(num - 1)).cwiseAbs2();
  return (sum / (num - begin)).cwiseSqrt();
}

RecentScatter ScatterOf(int num) {
  RecentScatter scatter;
  for (int k = 0; k < num; ++k) scatter.Add(WalkAt(k));
  return scatter;
}

TEST(RecentScatter, KnowsNothingBeforeTheFirstEstimate) {
  EXPECT_TRUE(std::isnan(RecentScatter().StdAbout(ParameterVector::Zero())[0]));
}

TEST(RecentScatter, IsExactWhileEachEstimateHasItsBlock) {
  // By hand: of 1, 2, 4 the last third is 4 alone (floor(2/3 3) = 2); of 1, 2, 4, 8 it is 4, 8.
  RecentScatter scatter;
  for (const double x : {1.0, 2.0, 4.0}) scatter.Add(ParameterVector::Constant(x));
  EXPECT_EQ(scatter.StdAbout(ParameterVector::Constant(4.0))[0], 0.0);
  scatter.Add(ParameterVector::Constant(8.0));
  EXPECT_NEAR(scatter.StdAbout(ParameterVector::Constant(8.0))[2], std::sqrt(8.0), 1e-15);
  for (const int num : {30, 301, 512}) {
    const ParameterVector truth = StdWrittenOut(2 * num / 3, num);
    const ParameterVector std = ScatterOf(num).StdAbout(WalkAt(num - 1));
    for (int i = 0; i < kNumParameters; ++i) EXPECT_NEAR(std[i], truth[i], 1e-12) << num;
  }
}

// The third may begin n / kMostBlocks estimates too early or too late, not further.
TEST(RecentScatter, BeginsNearTheThirdOfALongStream) {
  for (const int num : {513, 1753, 20011}) {
    const RecentScatter scatter = ScatterOf(num);
    EXPECT_LE(scatter.blocks().size(), RecentScatter::kMostBlocks);
    const ParameterVector std = scatter.StdAbout(WalkAt(num - 1));
    const int off = num / static_cast<int>(RecentScatter::kMostBlocks) + 1;
    bool is_one_of_them = false;
    for (int begin = 2 * num / 3 - off; begin <= 2 * num / 3 + off; ++begin) {
      is_one_of_them |= (std - StdWrittenOut(begin, num)).cwiseAbs().maxCoeff() < 1e-11;
    }
    EXPECT_TRUE(is_one_of_them) << num;
  }
}

TEST(RecentScatter, GoesOnFromItsBlocks) {
  const RecentScatter before = ScatterOf(1500);
  RecentScatter again(before.block_size(), before.blocks());
  for (int k = 1500; k < 3000; ++k) again.Add(WalkAt(k));
  EXPECT_EQ(again.StdAbout(WalkAt(2999)), ScatterOf(3000).StdAbout(WalkAt(2999)));
}

}  // namespace
}  // namespace fathom
