// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/residual_structure.h"

#include <cmath>
#include <numbers>
#include <random>

#include "handmade_identification.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// At rest in a tenth of a second, so that what is measured is what is left.
const ExtendedModel kStiff = {{.inertia = 1.0, .linear_damping = 50.0}, {}};

// A vehicle that holds still, measured with noise x_i = a x_{i-1} + n_i every 0.1 s.
Segment NoiseAtRest(int size, double a, std::mt19937* generator) {
  std::normal_distribution<double> normal(0.0, 0.01);
  Segment segment = SegmentAtRest(50.0, size);
  double x = 0.0;
  for (double& velocity : segment.velocity) velocity = x = a * x + normal(*generator);
  return segment;
}

// The standard error of the correlations is 0.02 at most.
TEST(ResidualStructure, HasTheCorrelationOfTheNoiseOverTrainingAndHeldOutData) {
  std::mt19937 generator(1);
  Signals signals;
  signals.train = {NoiseAtRest(8000, 0.8, &generator)};
  signals.held_out = {NoiseAtRest(4000, 0.8, &generator)};
  const ResidualStructure structure = StructureOfResidual(kStiff, signals);
  ASSERT_FALSE(structure.autocorrelation.lag.empty());
  EXPECT_NEAR(structure.autocorrelation.lag.back(), 30.0, 0.11);
  for (const int k : {1, 3, 6}) {
    EXPECT_NEAR(structure.autocorrelation.value[k - 1], std::pow(0.8, k), 0.08);
  }
  EXPECT_NEAR(structure.spectrum.level, 2.0 * 0.1 * 1e-4 / (1.0 - 0.64), 0.08 * 6e-5);
}

TEST(ResidualStructure, KnowsWhereTheCommandExcites) {
  std::mt19937 generator(2);
  Signals signals;
  signals.train = {NoiseAtRest(4000, 0.0, &generator)};
  EXPECT_FALSE(StructureOfResidual(kStiff, signals).excited);
  HeldCommand& command = signals.train[0].command;
  for (std::size_t i = 0; i < command.time.size(); ++i) {
    command.value[i] = 7.0 + 0.001 * std::sin(2.0 * std::numbers::pi * 0.4 * command.time[i]);
  }
  const auto excited = StructureOfResidual(kStiff, signals).excited;
  ASSERT_TRUE(excited);
  EXPECT_LT(excited->from, 0.4);
  EXPECT_GT(excited->to, 0.4);
  EXPECT_LT(excited->to - excited->from, 0.1);
}

TEST(ResidualStructure, IsEmptyWithoutData) {
  const ResidualStructure structure = StructureOfResidual(kStiff, {});
  EXPECT_TRUE(structure.autocorrelation.lag.empty());
  EXPECT_TRUE(structure.spectrum.frequency.empty());
}

TEST(ResidualStructure, CountsTheLagsOutsideOnEitherSide) {
  EXPECT_EQ(ShareOutside({{1, 2, 3, 4}, {0.3, -0.3, 0.1, -0.1}, {0.2, 0.2, 0.2, 0.2}}), 0.5);
}

TEST(ResidualStructure, SharesThePowerAboutABand) {
  const Spectrum spectrum = {{0.1, 0.2, 0.3, 0.4}, {1.0, 4.0, 2.0, 1.0}, 0.0, 0.0, 0.0};
  const PowerShares shares = SharesAbout({0.15, 0.35}, spectrum);
  EXPECT_DOUBLE_EQ(shares.below, 0.125);
  EXPECT_DOUBLE_EQ(shares.within, 0.75);
  EXPECT_DOUBLE_EQ(shares.above, 0.125);
  EXPECT_DOUBLE_EQ(WhiteShareWithin({0.15, 0.35}, spectrum), 0.5);
}

}  // namespace
}  // namespace fathom
