// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/inertia_check.h"

#include <string>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

const Body kRov = {.mass = 22.5};
const Body kFlatFish = {.mass = 274.0,
                        .size = {{2.10, 1.02, 0.50}}};  // data/vehicles/flatfish.yaml

TEST(InertiaCheck, PassesWhatAddedMassMakes) {
  EXPECT_FALSE(CheckInertia(Dof::kSurge, 30.0, 0.5, kRov));
  EXPECT_FALSE(CheckInertia(Dof::kHeave, 110.0, 0.5, kRov));
  EXPECT_FALSE(CheckInertia(Dof::kSurge, 21.0, 1.0, kRov));  // its interval reaches the mass
  EXPECT_FALSE(CheckInertia(Dof::kYaw, 0.9, 0.1, kRov));     // kg m^2
}

constexpr LoggedQuantities kForces = {.force = true, .velocity = true};
constexpr LoggedQuantities kThrusterSpeeds = {.thruster_speed = true, .velocity = true};

// Of an inertia of 30 kg that comes out so many times too large.
std::string SentenceOn(double factor, const LoggedQuantities& logged) {
  const Body body = {.mass = kRov.mass, .logged = logged};
  const auto finding = CheckInertia(Dof::kSurge, 30.0 * factor, 0.3 * factor, body);
  return finding ? finding->sentence : std::string();
}

TEST(InertiaCheck, NamesTheUnitThatExplainsIt) {
  EXPECT_THAT(SentenceOn(1e-3, kForces), HasSubstr("kN"));
  EXPECT_THAT(SentenceOn(3600.0, kThrusterSpeeds), HasSubstr("rpm"));
  EXPECT_THAT(SentenceOn(4.0 * 9.8696, kThrusterSpeeds), HasSubstr("rad/s"));
  EXPECT_THAT(SentenceOn(0.01, kForces), HasSubstr("cm/s"));
  EXPECT_THAT(SentenceOn(1.0 / 1.94384, kForces), HasSubstr("knots"));
  EXPECT_THAT(SentenceOn(1.0 / 9.80665, kForces), HasSubstr("kgf"));
}

// 70 kg, 3.1 masses, given in kgf: 7.1 kg. Pounds of force would make 1.4 masses of it.
TEST(InertiaCheck, NamesLastWhatTakesMuchAddedMass) {
  const Body body = {.mass = kRov.mass, .logged = kForces};
  const auto finding = CheckInertia(Dof::kSurge, 70.0 / 9.80665, 0.1, body);
  ASSERT_TRUE(finding);
  const std::size_t pounds = finding->sentence.find("lbf"),
                    kilograms = finding->sentence.find("kgf");
  ASSERT_NE(kilograms, std::string::npos) << finding->sentence;
  EXPECT_LT(pounds, kilograms);
}

TEST(InertiaCheck, NamesNoQuantityThatTheLogsDoNotHold) {
  EXPECT_THAT(SentenceOn(3600.0, kForces), Not(HasSubstr("thruster")));
  EXPECT_THAT(SentenceOn(1e-3, kThrusterSpeeds), AllOf(HasSubstr("mm/s"), Not(HasSubstr("kN"))));
  EXPECT_THAT(SentenceOn(1.0 / 1.94384, {.force = true}), Not(HasSubstr("knots")));
}

TEST(InertiaCheck, NamesAWrongMassWhateverElseExplainsIt) {
  EXPECT_THAT(SentenceOn(1e-3, kForces),
              EndsWith("; or a wrong `mass` in log.yaml or the vehicle file."));
  EXPECT_THAT(SentenceOn(1e-5, kForces),
              EndsWith("Check `mass` in log.yaml or the vehicle file, the units of force and "
                       "motion, and the clocks."));
  EXPECT_THAT(SentenceOn(1e-5, kThrusterSpeeds),
              EndsWith("Check `mass` in log.yaml or the vehicle file, the units of thruster speed "
                       "and motion, the coefficients of the thrusters, and the clocks."));
}

// A face of 1.02 m by 2.10 m: a plate of it takes along at most 1000 pi/4 1.02^2 2.10 = 1716 kg.
TEST(InertiaCheck, KnowsHowMuchWaterAFlatVehiclePushes) {
  EXPECT_NEAR(MostInertia(Dof::kHeave, kFlatFish), 2.0 * (274.0 + 1716.0), 1.0);
  EXPECT_FALSE(CheckInertia(Dof::kHeave, 1511.53, 5.0, kFlatFish));  // the paper's, 5.5 masses
  EXPECT_TRUE(CheckInertia(Dof::kHeave, 1511.53, 5.0, {.mass = 274.0}));
  EXPECT_TRUE(CheckInertia(Dof::kHeave, 4100.0, 5.0, kFlatFish));
  // A face of 1.02 m by 0.50 m, 200 kg: the rule of five masses, 1370 kg, is more.
  EXPECT_EQ(MostInertia(Dof::kSurge, kFlatFish), 5.0 * 274.0);
}

// Of commands in ampere the inertia is in A s^2/m: no mass.
TEST(InertiaCheck, PassesAModelOfAnotherForceUnit) {
  FittedModel model;
  model.force_unit = "N";
  model.model.inertia = 3.0;
  EXPECT_TRUE(CheckInertia(model, kRov));
  model.force_unit = "A";
  EXPECT_FALSE(CheckInertia(model, kRov));
}

// 22.5 kg, 0.6 m long, 0.4 m wide: a box of even density has 22.5 (0.6^2 + 0.4^2) / 12 = 0.975 kg
// m^2.
TEST(InertiaCheck, HoldsAMomentAgainstABoxOfTheVehiclesSize) {
  const Body body = {.mass = 22.5, .size = {{0.6, 0.4, 0.3}}, .logged = {.force = true}};
  EXPECT_FALSE(CheckInertia(Dof::kYaw, 1.5, 0.1, body));
  EXPECT_FALSE(CheckInertia(Dof::kYaw, 0.2, 0.01, body));
  const auto in_degrees = CheckInertia(Dof::kYaw, 0.054, 0.001, body);
  ASSERT_TRUE(in_degrees);
  EXPECT_EQ(in_degrees->severity, Severity::kWarning);
  EXPECT_THAT(in_degrees->sentence, HasSubstr("deg/s"));
  EXPECT_TRUE(CheckInertia(Dof::kYaw, 40.0, 1.0, body));
  EXPECT_FALSE(CheckInertia(Dof::kYaw, 0.054, 0.001, {.mass = 22.5}));
}

}  // namespace
}  // namespace fathom
