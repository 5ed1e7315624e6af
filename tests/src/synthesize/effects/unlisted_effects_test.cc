// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/unlisted_effects.h"

#include "fathom/synthesize/effects/random_wave.h"
#include "fathom/vehicle/effect_law.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

const EffectLaw<double>& Law(const std::string& name) {
  return FindUnlistedEffect(name)->law<double>();
}

// Resistance at a place and speed, with d_Q = 7 and d_L = 3, at t = 11.
double Resistance(const std::string& name, std::vector<double> p, double speed, double position) {
  const WaterState<double> water = {speed, speed, position, 0.0, 7.0, 3.0};
  return Law(name).resistance(p.data(), water, {.time = 11.0, .partner = {}});
}

TEST(UnlistedEffects, AreNotInTheCatalogue) {
  EXPECT_GE(UnlistedEffects().size(), 6u);
  for (const Effect* effect : UnlistedEffects()) {
    const std::string name(effect->info().name);
    EXPECT_TRUE(name.starts_with("unlisted.")) << name;
    EXPECT_EQ(FindEffect(name), nullptr);
    EXPECT_EQ(FindEffect(name.substr(9)), nullptr);
    EXPECT_EQ(FindUnlistedEffect(name), effect);
  }
  EXPECT_EQ(FindUnlistedEffect("thruster_lag"), nullptr);
}

TEST(UnlistedEffects, BacklashDragsTheThrustBehindTheCommand) {
  const double width = 2.0;
  double thrust = 0.0;
  // Up past the play, back within it, and out of it on the other side.
  const std::vector<std::pair<double, double>> expected = {
      {1.5, 0.0}, {5.0, 3.0}, {4.0, 3.0}, {1.5, 3.0}, {0.5, 2.5}, {-6.0, -4.0}, {-3.0, -4.0}};
  for (const auto& [command, force] : expected) {
    EXPECT_EQ(Law("unlisted.thrust_backlash").follow(&width, command, 0.1, &thrust), force);
    EXPECT_EQ(thrust, force);
  }
}

TEST(UnlistedEffects, LevelsRoundTheThrust) {
  const double step = 2.5;
  const auto thrust = [&](double force) {
    return Law("unlisted.thrust_levels").thrust(&step, {}, force, {});
  };
  EXPECT_EQ(thrust(1.2), 0.0);
  EXPECT_EQ(thrust(1.3), 2.5);
  EXPECT_EQ(thrust(-6.3), -7.5);
}

TEST(UnlistedEffects, HeatTakesThrustInTime) {
  const double p[] = {0.01, 20.0};
  double heat = 0.0;
  // 30 N for a time constant: heat 30 (1 - 1/e); 1 % of thrust for each newton.
  EXPECT_NEAR(Law("unlisted.thruster_heat").follow(p, -30.0, 1e-9, &heat), -30.0, 1e-9);
  Law("unlisted.thruster_heat").follow(p, -30.0, 20.0, &heat);
  EXPECT_NEAR(heat, 30.0 * (1.0 - std::exp(-1.0)), 1e-6);
  EXPECT_NEAR(Law("unlisted.thruster_heat").follow(p, -30.0, 1e-9, &heat),
              -30.0 * (1.0 - 0.01 * heat),
              1e-9);
}

TEST(UnlistedEffects, WashAddsDragWhileThrustersRun) {
  const double c = 0.4;
  const EffectLaw<double>& law = Law("unlisted.thrust_wash_drag");
  EXPECT_DOUBLE_EQ(law.thrust_at_speed(&c, 5.0, 0.3), 5.0 - 0.4 * 5.0 * 0.09);
  EXPECT_DOUBLE_EQ(law.thrust_at_speed(&c, -5.0, 0.3), -5.0 - 0.4 * 5.0 * 0.09);
  EXPECT_DOUBLE_EQ(law.thrust_at_speed(&c, 5.0, -0.3), 5.0 + 0.4 * 5.0 * 0.09);
}

TEST(UnlistedEffects, DragGrowsWithThePowerOneAndAHalf) {
  EXPECT_NEAR(Resistance("unlisted.power_damping", {4.0}, 0.25, 0.0), 0.5, 1e-15);
  EXPECT_NEAR(Resistance("unlisted.power_damping", {4.0}, -0.25, 0.0), -0.5, 1e-15);
  EXPECT_EQ(Resistance("unlisted.power_damping", {4.0}, 0.0, 0.0), 0.0);
}

TEST(UnlistedEffects, ABumpStandsAtItsPlace) {
  EXPECT_DOUBLE_EQ(Resistance("unlisted.place_bump", {4.0, 2.0, 0.5}, 0.1, 2.0), 4.0);
  EXPECT_DOUBLE_EQ(Resistance("unlisted.place_bump", {4.0, 2.0, 0.5}, 0.1, 1.5),
                   4.0 * std::exp(-0.5));
  EXPECT_LT(Resistance("unlisted.place_bump", {4.0, 2.0, 0.5}, 0.1, -2.0), 1e-12);
}

TEST(UnlistedEffects, ATetherPullsOnlyWhenItIsTaut) {
  EXPECT_EQ(Resistance("unlisted.slack_tether", {4.0, 2.0}, 0.1, 1.9), 0.0);
  EXPECT_DOUBLE_EQ(Resistance("unlisted.slack_tether", {4.0, 2.0}, 0.1, 2.5), 2.0);
  EXPECT_EQ(Resistance("unlisted.slack_tether", {4.0, 2.0}, 0.1, -9.0), 0.0);
}

TEST(UnlistedEffects, AWanderingCurrentMovesTheWater) {
  const double c = 0.2 * RandomWaveAt(5, 11.0 / 8.0);
  const auto damping = [](double v) { return 7.0 * std::abs(v) * v + 3.0 * v; };
  EXPECT_NE(c, 0.0);
  EXPECT_NEAR(Resistance("unlisted.wandering_current", {0.2, 8.0, 5.0}, 0.3, 0.0),
              damping(0.3 - c) - damping(0.3),
              1e-14);
}

}  // namespace
}  // namespace fathom
