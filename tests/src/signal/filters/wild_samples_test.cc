// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/wild_samples.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// White noise of standard deviation 1.
std::vector<double> Noise(int n) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  std::vector<double> noise;
  for (int i = 0; i < n; ++i) noise.push_back(normal(generator));
  return noise;
}

long NumWild(const std::vector<bool>& is_wild) {
  return std::count(is_wild.begin(), is_wild.end(), true);
}

TEST(WildSamples, AreThoseFarFromTheirNeighboursOnASlowStructure) {
  std::vector<double> residual = Noise(500);
  for (int i = 0; i < 500; ++i) residual[i] += 20.0 * std::sin(0.02 * i) + (i < 250 ? 0.0 : 15.0);
  for (const int i : {3, 120, 121, 400, 499}) residual[i] += i % 2 == 0 ? 12.0 : -12.0;
  const std::vector<bool> is_wild = WildSamples(residual);
  EXPECT_EQ(NumWild(is_wild), 5);
  for (const int i : {3, 120, 121, 400, 499}) EXPECT_TRUE(is_wild[i]) << i;
}

// Beyond six standard deviations lie 2e-9 of normal numbers.
TEST(WildSamples, AreNoneOfNormalNoise) { EXPECT_EQ(NumWild(WildSamples(Noise(20000))), 0); }

TEST(WildSamples, AreMeasuredByTheirOwnVariance) {
  std::vector<double> residual = Noise(500), variance(500, 1.0);
  residual[100] = residual[200] = 10.0;
  variance[200] = 16.0;  // 2.5 of its standard deviations
  const std::vector<bool> is_wild = WildSamples(residual, variance);
  EXPECT_TRUE(is_wild[100]);
  EXPECT_FALSE(is_wild[200]);
}

TEST(WildSamples, AreNoneOfLessThanElevenNorOfARecordAtRest) {
  EXPECT_EQ(NumWild(WildSamples(std::vector<double>{0, 0, 0, 0, 0, 99, 0, 0, 0, 0})), 0);
  std::vector<double> at_rest(100, 0.0);
  at_rest[50] = 1.0;
  EXPECT_EQ(NumWild(WildSamples(at_rest)), 0);
}

}  // namespace
}  // namespace fathom
