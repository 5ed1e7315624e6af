// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/damping_factors.h"

#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

std::vector<NoiseSample> SamplesAt(const std::vector<double>& time) {
  std::vector<NoiseSample> samples;
  for (const double t : time) samples.push_back({.time = t});
  return samples;
}

TEST(SetDampingFactors, TakesTheMeanSinceTheSampleBeforeInQuarterOctaves) {
  const std::vector<double> time = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  const std::vector<double> damping = {40.0, 60.0, 100.0, 230.0, 230.0, 12.0};
  std::vector<NoiseSample> samples = SamplesAt({0.5, 2.5, 4.5, 4.6, 5.5});
  SetDampingFactors(time, damping, 40.0, samples);
  EXPECT_DOUBLE_EQ(samples[0].damping_factor, 1.0);               // 40
  EXPECT_DOUBLE_EQ(samples[1].damping_factor, 2.0);               // (60 + 100) / 2
  EXPECT_DOUBLE_EQ(samples[2].damping_factor, std::exp2(2.5));    // 5.75 is 2^2.52
  EXPECT_DOUBLE_EQ(samples[3].damping_factor, std::exp2(2.5));    // nothing new
  EXPECT_DOUBLE_EQ(samples[4].damping_factor, std::exp2(-1.75));  // 0.3 is 2^-1.74
}

TEST(SetDampingFactors, StaysWithinThreeOctaves) {
  std::vector<NoiseSample> samples = SamplesAt({0.0, 1.0});
  SetDampingFactors(std::vector{0.0, 1.0}, std::vector{1e6, 0.0}, 7.0, samples);
  EXPECT_DOUBLE_EQ(samples[0].damping_factor, 8.0);
  EXPECT_DOUBLE_EQ(samples[1].damping_factor, 0.125);
}

TEST(SetDampingFactors, LeavesAVehicleWithoutDampingAlone) {
  std::vector<NoiseSample> samples = SamplesAt({0.0});
  SetDampingFactors(std::vector{0.0}, std::vector{5.0}, 0.0, samples);
  EXPECT_EQ(samples[0].damping_factor, 1.0);
}

}  // namespace
}  // namespace fathom
