// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Every effect's law by itself: docs/effects.md (2) to (31) worked out by hand at one point.

#include "fathom/vehicle/effect.h"

#include "fathom/vehicle/effect_law.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

constexpr double kClose = 1e-12;  // rounding of a few operations on numbers up to 100

const EffectLaw<double>& LawOf(const std::string& name) { return FindEffect(name)->law<double>(); }

EffectSetting Setting(Dof dof = Dof::kSurge, Dof partner = Dof::kSway) {
  return {.dof = dof, .partner = partner, .reference_force = 16.0};
}

Instant<double> Now(double time) {
  return {.time = time, .partner = {.velocity = 0.3, .yaw_rate = -0.2, .force = 7.0}};
}

double Thrust(const std::string& name, std::vector<double> p, double force, double time = 3.0) {
  return LawOf(name).thrust(p.data(), Setting(), force, Now(time));
}

double Resistance(const std::string& name, std::vector<double> p, double speed, double time = 3.0) {
  const WaterState<double> water = {.speed = speed,
                                    .relative_speed = speed - 0.1,
                                    .position = 2.5,
                                    .memory = 0.25,
                                    .quadratic_damping = 60.0,
                                    .linear_damping = 39.0};
  return LawOf(name).resistance(p.data(), water, Now(time));
}

TEST(EffectLaws, ShiftTheCommand) {
  const double p[] = {0.35};
  EXPECT_EQ(LawOf("time_offset").delay(p), 0.35);
  EXPECT_EQ(LawOf("sensor_clock_offset").pose_delay(p), 0.35);
}

TEST(EffectLaws, TurnOneForceIntoAnother) {
  EXPECT_NEAR(Thrust("thrust_dead_zone", {8.0}, 20.0), 12.0, kClose);
  EXPECT_NEAR(Thrust("thrust_dead_zone", {8.0}, -20.0), -12.0, kClose);
  EXPECT_EQ(Thrust("thrust_dead_zone", {8.0}, -7.0), 0.0);
  EXPECT_EQ(Thrust("thrust_saturation", {45.0}, 50.0), 45.0);
  EXPECT_EQ(Thrust("thrust_saturation", {45.0}, -50.0), -45.0);
  EXPECT_EQ(Thrust("thrust_saturation", {45.0}, 44.0), 44.0);
  // 16 (4 / 16)^1.5 = 2
  EXPECT_NEAR(Thrust("thrust_curve", {1.5}, 4.0), 2.0, kClose);
  EXPECT_NEAR(Thrust("thrust_curve", {1.5}, -4.0), -2.0, kClose);
  EXPECT_NEAR(Thrust("thrust_asymmetry", {0.3}, -50.0), -35.0, kClose);
  EXPECT_EQ(Thrust("thrust_asymmetry", {0.3}, 50.0), 50.0);
  EXPECT_NEAR(Thrust("thrust_fade", {0.004}, 50.0, 30.0), 44.0, kClose);
  EXPECT_EQ(Thrust("thrust_step_loss", {0.4, 30.0}, 50.0, 29.8), 50.0);
  EXPECT_NEAR(Thrust("thrust_step_loss", {0.4, 30.0}, 50.0, 30.0), 40.0, kClose);
  EXPECT_NEAR(Thrust("thrust_step_loss", {0.4, 30.0}, 50.0, 30.2), 30.0, kClose);
}

// T df/dt = target - f from 10 N towards 30 N: f = 30 - 20 exp(-t / T), and its mean over h.
TEST(EffectLaws, LagBehindTheCommand) {
  const double T = 0.4, h = 0.1;
  double state = 10.0;
  const double mean = LawOf("thruster_lag").follow(&T, 30.0, h, &state);
  EXPECT_NEAR(state, 30.0 - 20.0 * std::exp(-h / T), kClose);
  EXPECT_NEAR(mean, 30.0 - 20.0 * (1.0 - std::exp(-h / T)) * T / h, kClose);
}

TEST(EffectLaws, RampTheThrust) {
  const double rate = 40.0;
  double state = 10.0;
  // 4 N in 0.1 s, on the way to 30 N.
  EXPECT_NEAR(LawOf("thrust_slew_limit").follow(&rate, 30.0, 0.1, &state), 12.0, kClose);
  EXPECT_NEAR(state, 14.0, kClose);
  // 2 N down take 0.05 s, then it holds for as long: mean (13 + 12) / 2.
  EXPECT_NEAR(LawOf("thrust_slew_limit").follow(&rate, 12.0, 0.1, &state), 12.5, kClose);
  EXPECT_EQ(state, 12.0);
}

TEST(EffectLaws, LoseThrustWithSpeed) {
  const double k = 1.5;
  EXPECT_NEAR(LawOf("thrust_inflow_loss").thrust_at_speed(&k, 16.0, 0.5), 13.0, kClose);
  EXPECT_NEAR(LawOf("thrust_inflow_loss").thrust_at_speed(&k, -16.0, 0.5), -19.0, kClose);
}

TEST(EffectLaws, ResistInTheWater) {
  EXPECT_NEAR(Resistance("damping_asymmetry", {0.4}, -0.4), 0.4 * 60.0 * -0.25, kClose);
  EXPECT_EQ(Resistance("damping_asymmetry", {0.4}, 0.4), 0.0);
  EXPECT_NEAR(Resistance("cubic_damping", {200.0}, 0.5), 200.0 * 0.064, kClose);
  EXPECT_NEAR(Resistance("coulomb_friction", {6.0}, 0.004), 6.0 * std::tanh(0.8), kClose);
  EXPECT_NEAR(Resistance("coulomb_friction", {6.0}, -0.4), -6.0, kClose);
  EXPECT_NEAR(Resistance("position_stiffness", {3.0}, 0.4), 7.5, kClose);
  EXPECT_NEAR(Resistance("righting_moment", {3.0}, 0.4), 3.0 * std::sin(2.5), kClose);
  EXPECT_EQ(Resistance("buoyancy_step", {5.0, 30.0}, 0.4, 29.8), 0.0);
  EXPECT_NEAR(Resistance("buoyancy_step", {5.0, 30.0}, 0.4, 30.05), 3.75, kClose);
  EXPECT_NEAR(Resistance("buoyancy_drift", {0.02}, 0.4, 30.0), 0.6, kClose);
  EXPECT_NEAR(Resistance("periodic_force", {3.0, 2.0, 0.7}, 0.4, 5.0),
              -3.0 * std::sin(3.5) - 2.0 * std::cos(3.5),
              kClose);
  EXPECT_NEAR(Resistance("fluid_memory", {80.0, 4.0}, 0.4), 80.0 * 0.15, kClose);
  EXPECT_NEAR(Resistance("coriolis_coupling", {900.0}, 0.4), -54.0, kClose);
  EXPECT_NEAR(Resistance("velocity_coupling", {30.0}, 0.4), 9.0, kClose);
  EXPECT_NEAR(Resistance("thrust_crosstalk", {0.2}, 0.4), -1.4, kClose);
  const double current = 0.15, memory[] = {80.0, 4.0};
  EXPECT_NEAR(LawOf("steady_current").relative_speed(&current, 0.4), 0.25, kClose);
  EXPECT_NEAR(LawOf("fluid_memory").memory_rate(memory, 0.25, 0.65), 0.1, kClose);
}

// What the turned sensor shows of both DOFs, from a truth that only the test knows.
TEST(EffectLaws, TurnTheSensor) {
  const double a = 0.4, v = 0.7, v_j = 0.3;
  Instant<double> now;
  now.partner.velocity = v_j * std::cos(a) - v * std::sin(a);
  EXPECT_NEAR(LawOf("sensor_misalignment").reading(&a, Setting(), v, now),
              v * std::cos(a) + v_j * std::sin(a),
              kClose);
}

// v + omega x r, with one component each of omega (the partner's) and r (the arm).
TEST(EffectLaws, PutTheSensorOffTheCentre) {
  const double arm = 0.5;
  const struct {
    Dof dof, partner;
    double sign;
  } cases[] = {{Dof::kSurge, Dof::kYaw, -1.0},
               {Dof::kSurge, Dof::kPitch, 1.0},
               {Dof::kSway, Dof::kYaw, 1.0},
               {Dof::kSway, Dof::kRoll, -1.0},
               {Dof::kHeave, Dof::kRoll, 1.0},
               {Dof::kHeave, Dof::kPitch, -1.0}};
  for (const auto& each : cases) {
    EXPECT_NEAR(LawOf("lever_arm").reading(&arm, Setting(each.dof, each.partner), 0.7, Now(3.0)),
                0.7 + each.sign * 0.15,
                kClose)
        << Name(each.dof) << ", " << Name(each.partner);
  }
}

TEST(EffectLaws, SpoilTheReading) {
  const double bias = 0.05, scale = -0.2, jump[] = {0.3, 30.0};
  EXPECT_NEAR(LawOf("sensor_bias").reading(&bias, Setting(), 0.7, Now(3.0)), 0.75, kClose);
  EXPECT_NEAR(LawOf("pose_scale").displacement(&scale, 2.5, Now(3.0)), 2.0, kClose);
  EXPECT_NEAR(LawOf("marker_moved").displacement(jump, 2.5, Now(29.0)), 2.5, kClose);
  EXPECT_NEAR(LawOf("marker_moved").displacement(jump, 2.5, Now(31.0)), 2.8, kClose);
}

// T dy/dt = v - y for v = a + q t: y = a + q (t - T) + (y_0 - a + q T) exp(-t / T).
TEST(EffectLaws, SmoothTheReading) {
  const double T = 0.4, a = 0.2, q = 0.5, h = 0.1;
  double state = 0.6;
  LawOf("sensor_lag").follow_reading(&T, a, a + q * h, h, &state);
  EXPECT_NEAR(state, a + q * (h - T) + (0.6 - a + q * T) * std::exp(-h / T), kClose);
}

// What the sensor shows of the partner too, and so what a log holds of it: the two readings agree.
TEST(EffectLaws, TurnBothReadingsAsOne) {
  const double a = 0.4, v = 0.7, v_j = 0.3;
  double reading = v;
  Instant<double> now;
  now.partner.velocity = v_j;
  LawOf("sensor_misalignment").both_readings(&a, &reading, &now.partner.velocity);
  EXPECT_NEAR(reading, v * std::cos(a) + v_j * std::sin(a), kClose);
  EXPECT_NEAR(now.partner.velocity, v_j * std::cos(a) - v * std::sin(a), kClose);
  EXPECT_NEAR(LawOf("sensor_misalignment").reading(&a, Setting(), v, now), reading, kClose);
}

// Everything an effect does at one instant, in one number.
double ResponseOf(const Effect& effect, const Instant<double>& now) {
  const EffectLaw<double>& law = effect.law<double>();
  const std::vector<double> p(effect.info().parameters.size(), 0.4);
  const WaterState<double> water = {0.31, 0.29, 0.53, 0.17, 2.0, 3.0};
  double sum = 0.0;
  if (law.thrust) sum += law.thrust(p.data(), Setting(), 7.3, now);
  if (law.resistance) sum += law.resistance(p.data(), water, now);
  if (law.reading) sum += law.reading(p.data(), Setting(), 0.31, now);
  if (law.displacement) sum += law.displacement(p.data(), 0.53, now);
  return sum;
}

TEST(EffectCatalogue, SaysOfEachEffectWhatItReadsOfOtherDofs) {
  for (const Effect* effect : EffectCatalogue()) {
    const auto reads = [&](double PartnerReading<double>::*measurement) {
      Instant<double> other = Now(3.0);
      other.partner.*measurement *= 1.61;
      return ResponseOf(*effect, other) != ResponseOf(*effect, Now(3.0));
    };
    const PartnerInfo partner = effect->info().partner.value_or(PartnerInfo{});
    EXPECT_EQ(reads(&PartnerReading<double>::velocity), partner.velocity) << effect->info().name;
    EXPECT_EQ(reads(&PartnerReading<double>::yaw_rate), partner.yaw_rate) << effect->info().name;
    EXPECT_EQ(reads(&PartnerReading<double>::force), partner.force) << effect->info().name;
  }
}

// Weight rights what tilts: roll and pitch.
TEST(EffectCatalogue, KnowsAlongWhichDofsAnEffectCanAct) {
  for (const Effect* effect : EffectCatalogue()) {
    for (const Dof dof : kAllDofs) {
      const bool tilts = dof == Dof::kRoll || dof == Dof::kPitch;
      EXPECT_EQ(CanActAlong(effect->info(), dof), tilts || effect->info().name != "righting_moment")
          << effect->info().name << ", " << Name(dof);
    }
  }
}

// v + omega x r: a rotation about another axis moves the sensor along this one.
TEST(EffectCatalogue, KnowsWhichDofsCanTakePart) {
  const auto partners = [](const char* name, Dof dof) {
    std::vector<Dof> dofs;
    for (const Dof partner : kAllDofs) {
      if (CanBePartner(FindEffect(name)->info(), dof, partner)) dofs.push_back(partner);
    }
    return dofs;
  };
  using testing::ElementsAre;
  EXPECT_THAT(partners("lever_arm", Dof::kSurge), ElementsAre(Dof::kPitch, Dof::kYaw));
  EXPECT_THAT(partners("lever_arm", Dof::kSway), ElementsAre(Dof::kRoll, Dof::kYaw));
  EXPECT_THAT(partners("lever_arm", Dof::kHeave), ElementsAre(Dof::kRoll, Dof::kPitch));
  EXPECT_THAT(partners("lever_arm", Dof::kYaw), ElementsAre());
  EXPECT_THAT(partners("coriolis_coupling", Dof::kSurge), ElementsAre(Dof::kSway));
  EXPECT_THAT(partners("coriolis_coupling", Dof::kHeave), ElementsAre());
  EXPECT_THAT(partners("coriolis_coupling", Dof::kYaw), ElementsAre(Dof::kSurge, Dof::kSway));
  EXPECT_THAT(partners("sensor_misalignment", Dof::kRoll), ElementsAre(Dof::kPitch, Dof::kYaw));
  EXPECT_THAT(partners("velocity_coupling", Dof::kHeave),
              ElementsAre(Dof::kSurge, Dof::kSway, Dof::kRoll, Dof::kPitch, Dof::kYaw));
  EXPECT_THAT(partners("thruster_lag", Dof::kSurge), ElementsAre());
}

TEST(EffectCatalogue, HoldsEachNameOnceAndEachNullWithinItsBounds) {
  std::set<std::string> names;
  for (const Effect* effect : EffectCatalogue()) {
    const EffectInfo& info = effect->info();
    EXPECT_TRUE(names.insert(std::string(info.name)).second) << info.name;
    EXPECT_EQ(FindEffect(info.name), effect);
    EXPECT_FALSE(info.parameters.empty()) << info.name;
    // A sentence goes on with the cause after "comes from"; the advice stands alone.
    EXPECT_NE(info.cause.back(), '.') << info.name;
    EXPECT_EQ(info.advice.back(), '.') << info.name;
    for (const EffectParameter& parameter : info.parameters) {
      EXPECT_NE(parameter.drawn.unit, nullptr) << info.name;
      EXPECT_LT(parameter.drawn.smallest, parameter.drawn.largest) << info.name;
      EXPECT_LT(parameter.lower, parameter.upper) << info.name;
      if (std::isnan(parameter.null)) continue;
      EXPECT_GE(parameter.null, parameter.lower) << info.name;
      EXPECT_LE(parameter.null, parameter.upper) << info.name;
    }
  }
  EXPECT_EQ(names.size(), 30u);  // docs/effects.md
}

std::string TextOf(const std::string& file) {
  std::ifstream stream(std::string(FATHOM_SOURCE_DIR "/") + file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The first C++ block of the page is the struct that the tests compile.
TEST(AddingAnEffect, ShowsTheStructThatTheTestsCompile) {
  const std::string page = TextOf("docs/adding_an_effect.md");
  const std::string fence = "```cpp\n";
  const std::size_t begin = page.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t first = begin + fence.size();
  const std::string shown = page.substr(first, page.find("```", first) - first);
  EXPECT_THAT(shown, HasSubstr("struct SquareRootDrag {"));
  EXPECT_THAT(shown, HasSubstr("return p[0] * water.speed / sqrt(size);"));
  EXPECT_THAT(TextOf("tests/src/vehicle/square_root_drag.h"), HasSubstr(shown));
}

}  // namespace
}  // namespace fathom
