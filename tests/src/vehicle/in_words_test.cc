// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effects/in_words.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(InWords, WritesEffectsAndParametersWithSpaces) {
  EXPECT_EQ(InWords("It comes from friction (coulomb_friction), or from thruster_lag."),
            "It comes from friction (coulomb friction), or from thruster lag.");
  EXPECT_EQ(InWords("it leaves quadratic_damping unknown."),
            "it leaves quadratic damping unknown.");
  EXPECT_EQ(InWords("thrust_crosstalk(sway) and `consistent`"),
            "thrust crosstalk(sway) and \"consistent\"");
}

TEST(InWords, LeavesNamesOfFilesAndOthersAlone) {
  for (const char* text : {"pool_rov_surge has no model.",
                           "dives/thruster_lag gives no model.",
                           "fathom_identify --log=thruster_lag",
                           "thruster_lag.csv",
                           "thruster_lag_2"}) {
    EXPECT_EQ(InWords(text), text);
  }
}

}  // namespace
}  // namespace fathom
