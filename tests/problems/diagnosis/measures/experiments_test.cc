// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/experiments.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <string>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

std::string Deciding(const char* cause, const char* rival) {
  return DecidingExperiment({FindEffect(cause), {}}, {{FindEffect(rival), {}}}).text;
}

// EFFECTS.md, "What cannot be told apart": pair by pair what decides.
TEST(DecidingExperiment, IsThatOfEffectsPage) {
  const struct {
    const char *a, *b, *regex;
  } cases[] = {
      {"thruster_lag", "time_offset", "several sizes"},
      {"thruster_lag", "thrust_slew_limit", "[Ss]teps of several sizes"},
      {"thrust_dead_zone", "coulomb_friction", "[Ss]mall commands.*coasts, in both directions"},
      {"thrust_saturation", "cubic_damping", "[Ll]arge commands at low speed"},
      {"thrust_asymmetry", "damping_asymmetry", "[Rr]eversals while moving"},
      {"coulomb_friction", "cubic_damping", "range of speeds"},
      {"position_stiffness", "buoyancy_drift", "away and return"},
      {"position_stiffness", "buoyancy_step", "away and return"},
      {"position_stiffness", "righting_moment", "more than a radian"},
      {"thruster_lag", "sensor_lag", "quadratic drag"},
      {"velocity_coupling", "thrust_crosstalk", "other DOF moves without being commanded"},
      {"sensor_misalignment", "velocity_coupling", "other DOF moves without being commanded"},
  };
  for (const auto& each : cases) {
    EXPECT_THAT(Deciding(each.a, each.b), ContainsRegex(each.regex)) << each.a << ", " << each.b;
    EXPECT_EQ(Deciding(each.a, each.b), Deciding(each.b, each.a));
  }
}

// Identical at every speed: no run with this sensor alone decides, and the text says so.
TEST(DecidingExperiment, SaysWhereNoVelocityLogDecides) {
  EXPECT_THAT(Deciding("sensor_bias", "steady_current"),
              testing::AllOf(HasSubstr("No velocity log can decide"), HasSubstr("poses")));
  EXPECT_FALSE(
      DecidingExperiment({FindEffect("sensor_bias"), {}}, {{FindEffect("steady_current"), {}}})
          .decides);
}

// What belongs to the run goes with any other run; among causes of the vehicle it must be one that
// tells them apart.
TEST(DecidingExperiment, IsNotTheSameRunAgainWhereThatLeavesRivals) {
  const Suspect dead_zone = {FindEffect("thrust_dead_zone"), {}};
  const Suspect curve = {FindEffect("thrust_curve"), {}};
  const Suspect wave = {FindEffect("periodic_force"), {}};
  EXPECT_THAT(DecidingExperiment(dead_zone, {wave}).text, HasSubstr("same experiment again"));
  EXPECT_THAT(DecidingExperiment(wave, {dead_zone}).text, HasSubstr("same experiment again"));
  EXPECT_THAT(DecidingExperiment(dead_zone, {wave, curve}).text,
              HasSubstr("steps of several sizes"));
}

TEST(DecidingExperiment, SaysSomethingForEveryPairOfTheCatalogue) {
  for (const Effect* a : EffectCatalogue()) {
    for (const Effect* b : EffectCatalogue()) {
      if (a == b) continue;
      const std::string text = DecidingExperiment({a, {}}, {{b, {}}}).text;
      ASSERT_FALSE(text.empty()) << a->info().name << ", " << b->info().name;
      EXPECT_EQ(text.back(), '.') << text;
      EXPECT_EQ(text, DecidingExperiment({b, {}}, {{a, {}}}).text);
    }
  }
}

}  // namespace
}  // namespace fathom
