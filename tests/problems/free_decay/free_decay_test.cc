// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/free_decay.h"

#include "fathom/base/interval95.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// The turn of a small vehicle that coasts, and the roll of one that was tilted and let go.
constexpr DecayRates kYaw = {0.2, 0.48, 0.0, 0.0};
constexpr DecayRates kRoll = {0.25, 0.6, 4.0, 0.0};

struct Noise {
  double std = 0.0;
  double memory = 0.0;  // correlation from sample to sample
  unsigned seed = 1;
};

DecayStretch Decay(const DecayRates& rates,
                   double v0,
                   double x0,
                   DecayOutput output,
                   const Noise& noise = {},
                   double rest = 0.0) {
  DecayStretch stretch;
  for (int i = 0; i < 240; ++i) stretch.time.push_back(100.0 + 0.05 * i);
  std::mt19937 random(noise.seed);
  std::normal_distribution<double> normal;
  double e = normal(random);
  for (const DecaySample& sample : SimulateDecay(rates, v0, x0, stretch.time)) {
    const double motion =
        output == DecayOutput::kVelocity ? sample.velocity : sample.displacement + rest;
    stretch.motion.push_back(motion + noise.std * e);
    e = noise.memory * e + std::sqrt(1.0 - noise.memory * noise.memory) * normal(random);
  }
  return stretch;
}

bool Covers(const FreeDecaySummary& summary, int rate, double truth) {
  const double std = std::sqrt(summary.covariance(rate, rate));
  return std::abs(summary.rates[static_cast<std::size_t>(rate)] - truth) <= kStdsOf95 * std;
}

TEST(FreeDecay, FindsTheTruthOfPerfectData) {
  const DecayStretch stretch = Decay(kYaw, 0.73, 0.0, DecayOutput::kVelocity);
  const FreeDecaySummary summary = FitFreeDecay({&stretch, 1});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_LT(summary.rms, 1e-9);
  EXPECT_NEAR(summary.rates[kLinearRate], 0.2, 1e-6);
  EXPECT_NEAR(summary.rates[kQuadraticRate], 0.48, 1e-6);
  EXPECT_NEAR(summary.rates[kConstantRate], 0.0, 1e-6);
  EXPECT_EQ(summary.rates[kStiffnessRate], 0.0);
}

TEST(FreeDecay, FindsTheTruthOfPerfectDisplacements) {
  const DecayStretch stretch = Decay(kYaw, 0.73, 5.0, DecayOutput::kDisplacement);
  const FreeDecaySummary summary =
      FitFreeDecay({&stretch, 1}, {.output = DecayOutput::kDisplacement});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.rates[kLinearRate], 0.2, 1e-5);
  EXPECT_NEAR(summary.rates[kQuadraticRate], 0.48, 1e-5);
}

// A decay of linear damping alone has the period 2 pi / sqrt(c - a^2 / 4): here 3.2 s.
TEST(FreeDecay, FindsTheRightingStiffnessOfARollFromItsPeriod) {
  const double period = 3.2, a = 0.3;
  const double w = 2.0 * std::numbers::pi / period;
  DecayStretch stretch;
  for (int i = 0; i < 400; ++i) {
    const double t = 0.05 * i;
    stretch.time.push_back(t);
    stretch.motion.push_back(0.02 + 0.3 * std::exp(-a * t / 2.0) *
                                        (std::cos(w * t) + a / 2.0 / w * std::sin(w * t)));
  }
  const FreeDecaySummary summary =
      FitFreeDecay({&stretch, 1}, {.output = DecayOutput::kDisplacement, .has_stiffness = true});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.rates[kStiffnessRate], w * w + a * a / 4.0, 1e-4);
  EXPECT_NEAR(summary.rates[kLinearRate], a, 1e-4);
  EXPECT_NEAR(summary.rates[kQuadraticRate], 0.0, 1e-3);
}

TEST(FreeDecay, FindsTheStiffnessFromTheSpeedAloneToo) {
  const DecayStretch stretch = Decay(kRoll, 0.0, 0.35, DecayOutput::kVelocity);
  const FreeDecaySummary summary = FitFreeDecay({&stretch, 1}, {.has_stiffness = true});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.rates[kStiffnessRate], 4.0, 1e-5);
  EXPECT_NEAR(summary.rates[kLinearRate], 0.25, 1e-5);
  EXPECT_NEAR(summary.rates[kQuadraticRate], 0.6, 1e-5);
}

TEST(FreeDecay, TakesSeveralStretchesTogether) {
  const DecayStretch stretches[] = {Decay(kYaw, 0.73, 0.0, DecayOutput::kVelocity),
                                    Decay(kYaw, -0.3, 0.0, DecayOutput::kVelocity)};
  const FreeDecaySummary summary = FitFreeDecay(stretches);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.rates[kLinearRate], 0.2, 1e-6);
  EXPECT_NEAR(summary.duration, 2 * 239 * 0.05, 1e-9);
}

TEST(FreeDecay, IsNotMovedByWildSamples) {
  DecayStretch stretch = Decay(kYaw, 0.73, 0.0, DecayOutput::kVelocity, {.std = 0.003});
  for (std::size_t i = 7; i < stretch.motion.size(); i += 25) stretch.motion[i] += 1.0;
  const FreeDecaySummary summary = FitFreeDecay({&stretch, 1});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_TRUE(Covers(summary, kLinearRate, 0.2)) << summary.rates[kLinearRate];
  EXPECT_TRUE(Covers(summary, kQuadraticRate, 0.48)) << summary.rates[kQuadraticRate];
}

struct CoverageCase {
  const char* name;
  DecayRates rates;
  double v0, x0;
  FreeDecayOptions options;
  double std, memory;
};

class FreeDecayCoverage : public ::testing::TestWithParam<CoverageCase> {};

// Of 200 runs 95 % are 190, with a standard deviation of 3.1: 181 is three below. Coloured noise
// of 240 samples leaves few to tell its colour, and 5 more are granted.
TEST_P(FreeDecayCoverage, OfThe95PercentIntervals) {
  const auto& [name, rates, v0, x0, options, std, memory] = GetParam();
  const int num_runs = 200, fewest = memory > 0.0 ? 176 : 181;
  std::array<int, kNumDecayRates> covered = {};
  int usable = 0;
  for (int seed = 1; seed <= num_runs; ++seed) {
    const DecayStretch stretch =
        Decay(rates, v0, x0, options.output, {std, memory, static_cast<unsigned>(seed)});
    const FreeDecaySummary summary = FitFreeDecay({&stretch, 1}, options);
    usable += summary.IsUsable() ? 1 : 0;
    for (int rate = 0; rate < kNumDecayRates; ++rate) {
      covered[static_cast<std::size_t>(rate)] +=
          Covers(summary, rate, rates[static_cast<std::size_t>(rate)]) ? 1 : 0;
    }
  }
  EXPECT_EQ(usable, num_runs);
  for (const int count : covered) EXPECT_GE(count, fewest) << ::testing::PrintToString(covered);
}

INSTANTIATE_TEST_SUITE_P(
    Cases,
    FreeDecayCoverage,
    ::testing::Values(
        CoverageCase{"yaw", kYaw, 0.73, 0.0, {}, 0.003, 0.0},
        CoverageCase{"coloured", kYaw, 0.73, 0.0, {}, 0.003, 0.8},
        CoverageCase{
            "bearing", kYaw, 0.73, 0.0, {.output = DecayOutput::kDisplacement}, 0.003, 0.0},
        CoverageCase{"roll",
                     kRoll,
                     0.0,
                     0.35,
                     {.output = DecayOutput::kDisplacement, .has_stiffness = true},
                     0.005,
                     0.0}),
    [](const auto& info) { return info.param.name; });

TEST(FreeDecay, RefusesWhatDoesNotDecay) {
  const FreeDecayOptions options;
  DecayStretch still = Decay(kYaw, 0.0, 0.0, DecayOutput::kVelocity, {.std = 0.003});
  EXPECT_FALSE(FitFreeDecay({&still, 1}).IsUsable());
  DecayStretch steady = Decay({}, 0.5, 0.0, DecayOutput::kVelocity, {.std = 0.003});
  EXPECT_FALSE(FitFreeDecay({&steady, 1}).IsUsable());
  DecayStretch zero = still;
  for (double& value : zero.motion) value = 0.0;
  EXPECT_THAT(FitFreeDecay({&zero, 1}).message, HasSubstr("Nothing decays"));
  DecayStretch shorter = still;
  shorter.time.resize(5);
  shorter.motion.resize(5);
  EXPECT_THAT(FitFreeDecay({&shorter, 1}).message, HasSubstr("only 5 samples"));
  EXPECT_FALSE(FitFreeDecay({}).IsUsable());
}

}  // namespace
}  // namespace fathom
