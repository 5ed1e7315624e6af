// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/mass_check.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

TEST(MassCheck, IsSilentOnOneVehicleWeighedTwice) {
  EXPECT_FALSE(CheckMass(22.5, 22.5));
  EXPECT_FALSE(CheckMass(22.5, 24.0));
  EXPECT_FALSE(CheckMass(24.0, 22.5));
}

TEST(MassCheck, NotesAPayloadAndWarnsOfAnotherUnit) {
  const auto payload = CheckMass(30.0, 22.5);
  ASSERT_TRUE(payload);
  EXPECT_EQ(payload->code, "mass");
  EXPECT_EQ(payload->severity, Severity::kNote);
  const auto wrong = CheckMass(0.3, 22.5);
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->severity, Severity::kWarning);
  EXPECT_THAT(wrong->sentence,
              testing::HasSubstr("a mass of 0.3 kg, the vehicle file 22.5 kg: 75 times as much."));
  EXPECT_EQ(CheckMass(50.0, 22.5)->severity, Severity::kWarning);
}

}  // namespace
}  // namespace fathom
