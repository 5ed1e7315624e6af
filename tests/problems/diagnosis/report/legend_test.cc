// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/legend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(LegendOf, ExplainsWhatIsShownAndNothingElse) {
  EXPECT_EQ(LegendOf("cause  held-out gain"), "");
  EXPECT_EQ(LegendOf("cause  p-value  held-out gain"),
            "p-value: how often noise alone would score as well if nothing were missing\n");
  EXPECT_THAT(LegendOf("cause  p-value  evidence (BIC)"),
              testing::MatchesRegex("p-value: .*\nevidence \\(BIC\\): .*above 10 is strong\n"));
}

TEST(NoiseFloorText, SaysWhatNoModelFallsBelow) {
  Diagnosis diagnosis;
  EXPECT_EQ(NoiseFloorText(diagnosis), "");
  diagnosis.has_velocity = true;
  diagnosis.noise_nmae = 0.0591;
  EXPECT_EQ(
      NoiseFloorText(diagnosis),
      "noise alone (the scatter from sample to sample) gives a velocity NMAE of about 0.059\n");
}

}  // namespace
}  // namespace fathom
