// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/inertia_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

TEST(InertiaCheck, PassesWhatAddedMassMakes) {
  EXPECT_FALSE(CheckInertia(Dof::kSurge, 30.0, 0.5, 22.5));
  EXPECT_FALSE(CheckInertia(Dof::kHeave, 110.0, 0.5, 22.5));
  EXPECT_FALSE(CheckInertia(Dof::kSurge, 21.0, 1.0, 22.5));  // its interval reaches the mass
  EXPECT_FALSE(CheckInertia(Dof::kYaw, 0.9, 0.1, 22.5));     // kg m^2
}

TEST(InertiaCheck, NamesTheUnitThatExplainsIt) {
  const double inertia = 30.0, mass = 22.5;
  const auto sentence = [&](double factor) {
    const auto finding = CheckInertia(Dof::kSurge, factor * inertia, factor * 0.3, mass);
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

}  // namespace
}  // namespace fathom
