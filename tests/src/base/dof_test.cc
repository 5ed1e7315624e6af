// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/dof.h"

#include <string>

#include "error_from.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(Dof, HasTheNamesAndUnitsOfSname) {
  EXPECT_EQ(Name(Dof::kHeave), "heave");
  EXPECT_EQ(VelocityColumn(Dof::kHeave), "w");
  EXPECT_EQ(ForceColumn(Dof::kYaw), "tau_yaw");
  EXPECT_EQ(VelocityColumn(Dof::kYaw), "r");
  EXPECT_EQ(DisplacementUnit(Dof::kHeave), "m");
  EXPECT_EQ(DisplacementUnit(Dof::kPitch), "rad");
  EXPECT_EQ(VelocityUnit(Dof::kSway), "m/s");
  EXPECT_EQ(VelocityUnit(Dof::kRoll), "rad/s");
  EXPECT_EQ(ForceUnit(Dof::kSurge), "N");
  EXPECT_EQ(ForceUnit(Dof::kPitch), "N m");
}

TEST(Dof, IsFoundAgainByItsName) {
  for (const Dof dof : kAllDofs) EXPECT_EQ(ParseDof(std::string(Name(dof))), dof);
  EXPECT_FALSE(DofFromName("Surge").has_value());
}

TEST(Dof, ListsTheNamesWhenThereIsNoSuchName) {
  EXPECT_EQ(ErrorFrom([&] { ParseDof("surg"); }),
            "is 'surg', expected surge, sway, heave, roll, pitch or yaw.");
}

}  // namespace
}  // namespace fathom
