// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/legend.h"

#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

TEST(LegendOf, ExplainsWhatIsShownAndNothingElse) {
  Table causes, candidates;
  causes.columns = {{"cause"}, {"p-value"}};
  candidates.columns = {{"p-value"}, {"evidence (BIC)"}};
  EXPECT_EQ(LegendOf({}), "");
  EXPECT_EQ(
      LegendOf(std::vector{causes}),
      "p-value: how often noise alone would gain as much if nothing were missing (the refitted "
      "gain; the score where there is none)\n");
  EXPECT_THAT(LegendOf(std::vector{causes, candidates}),
              testing::MatchesRegex("p-value: .*\nevidence \\(BIC\\): .*above 10 is strong\n"));
}

TEST(LegendOf, SaysWhatAFreeRunIsWhereARowTellsOfOne) {
  Table table;
  table.columns = {{"result"}};
  table.rows = {{{"refused: gain 75, but free runs do not improve by it"}}};
  EXPECT_EQ(LegendOf(std::vector{table}), "free run: the model simulated from the command alone\n");
}

TEST(LegendOf, TakesNoWordOfACellForAHeading) {
  Table table;
  table.columns = {{"result"}};
  table.rows = {{{"dropped: score 2.0; noise alone reaches 11.2"}}};
  EXPECT_EQ(LegendOf(std::vector{table}), "");
}

TEST(NoiseFloorText, SaysWhatNoModelFallsBelow) {
  Diagnosis diagnosis;
  EXPECT_EQ(NoiseFloorText(diagnosis), "");
  diagnosis.has_velocity = true;
  diagnosis.noise_nmae = 0.0591;
  diagnosis.extended.held_out.nmae = 0.0592;
  EXPECT_EQ(
      NoiseFloorText(diagnosis),
      "noise alone (the scatter from sample to sample) gives a velocity NMAE of about 0.059\n");
  diagnosis.extended.held_out.nmae = 0.0590;
  EXPECT_THAT(NoiseFloorText(diagnosis),
              testing::EndsWith("about 0.059: the error of this model is no more than noise\n"));
}

}  // namespace
}  // namespace fathom
