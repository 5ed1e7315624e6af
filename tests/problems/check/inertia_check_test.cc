// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/inertia_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

const Body kRov = {.mass = 22.5};
const Body kFlatFish = {.mass = 274.0,
                        .size = {{2.10, 1.02, 0.50}}};  // data/vehicles/flatfish.yaml

TEST(InertiaCheck, PassesWhatAddedMassMakes) {
  EXPECT_FALSE(CheckInertia(Dof::kSurge, 30.0, 0.5, kRov));
  EXPECT_FALSE(CheckInertia(Dof::kHeave, 110.0, 0.5, kRov));
  EXPECT_FALSE(CheckInertia(Dof::kSurge, 21.0, 1.0, kRov));  // its interval reaches the mass
  EXPECT_FALSE(CheckInertia(Dof::kYaw, 0.9, 0.1, kRov));     // kg m^2
}

TEST(InertiaCheck, NamesTheUnitThatExplainsIt) {
  const double inertia = 30.0;
  const auto sentence = [&](double factor) {
    const auto finding = CheckInertia(Dof::kSurge, factor * inertia, factor * 0.3, kRov);
    return finding ? finding->sentence : std::string();
  };
  EXPECT_THAT(sentence(1e-3), HasSubstr("kN"));
  EXPECT_THAT(sentence(3600.0), HasSubstr("rpm"));
  EXPECT_THAT(sentence(4.0 * 9.8696), HasSubstr("rad/s"));
  EXPECT_THAT(sentence(0.01), HasSubstr("cm/s"));
  EXPECT_THAT(sentence(1.0 / 1.94384), HasSubstr("knots"));
  EXPECT_THAT(sentence(1.0 / 9.80665), HasSubstr("kgf"));
  EXPECT_THAT(sentence(1e-5), HasSubstr("Check the units"));
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

}  // namespace
}  // namespace fathom
