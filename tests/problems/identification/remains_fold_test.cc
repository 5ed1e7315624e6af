// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/remains_fold.h"

#include "handmade_identification.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A hundred lags of 0.1 s each, the first of them at one correlation and the others at 0.
ResidualStructure Correlated(int num_lags, double value) {
  ResidualStructure structure;
  for (int k = 1; k <= 100; ++k) {
    structure.autocorrelation.lag.push_back(0.1 * k);
    structure.autocorrelation.value.push_back(k <= num_lags ? value : 0.0);
    structure.autocorrelation.bound.push_back(0.05);
  }
  return structure;
}

// White noise leaves 5 of 100 outside, and hardly ever more than 11.
TEST(AutocorrelationSentence, TellsWhiteNoiseFromMore) {
  EXPECT_THAT(AutocorrelationSentence(Correlated(11, 0.4), Family::kOutputError),
              AllOf(HasSubstr("looks like white noise"), HasSubstr("11 %")));
  EXPECT_THAT(AutocorrelationSentence(Correlated(12, -0.4), Family::kOutputError),
              AllOf(HasSubstr("1 s apart have a correlation of -0.40, and 12 %"),
                    HasSubstr("they are too short")));
}

TEST(AutocorrelationSentence, SaysWhatTheAdaptiveLawDoesNotWeigh) {
  EXPECT_THAT(AutocorrelationSentence(Correlated(50, 0.4), Family::kAdaptive),
              HasSubstr("adaptive law do not weigh"));
}

// Power below, within and above the band, each a third of the frequencies.
ResidualStructure Coloured(double below, double within, double above) {
  ResidualStructure structure;
  structure.spectrum.frequency = {0.1, 0.2, 0.3};
  structure.spectrum.density = {below, within, above};
  structure.excited = TimeInterval{0.15, 0.25};
  return structure;
}

TEST(SpectrumSentence, SaysWhereThePowerIs) {
  EXPECT_THAT(SpectrumSentence(Coloured(1.0, 8.0, 1.0)),
              AllOf(HasSubstr("From 0.15 to 0.25 Hz"),
                    HasSubstr("lies 80 %"),
                    HasSubstr("white noise: 33 %"),
                    HasSubstr("10 % lies below and 10 % above"),
                    HasSubstr("a response that the model lacks, or")));
  EXPECT_THAT(SpectrumSentence(Coloured(3.0, 1.0, 2.0)), HasSubstr("no sign of a response"));
}

TEST(SpectrumSentence, JudgesNothingWhereNearlyAllIsExcited) {
  ResidualStructure structure = Coloured(0.0, 8.0, 1.0);
  structure.excited = TimeInterval{0.05, 0.25};
  EXPECT_THAT(SpectrumSentence(structure), HasSubstr("tells little"));
}

TEST(SpectrumSentence, SaysNothingWhereNothingIsExcited) {
  ResidualStructure structure = Coloured(1.0, 2.0, 3.0);
  structure.excited.reset();
  EXPECT_EQ(SpectrumSentence(structure), "");
}

TEST(RemainsFold, HoldsBothChartsAndTheTable) {
  Signals signals;
  signals.train = {SegmentAtRest(0.0, 400)};
  for (std::size_t i = 0; i < 400; i += 2) signals.train[0].velocity[i] = 0.01;
  const PageFold fold = RemainsFold(HandmadeRow(Family::kOutputError, 0.02, 0.03), signals);
  EXPECT_EQ(fold.summary, "What the model leaves");
  ASSERT_EQ(fold.curves.size(), 2u);
  EXPECT_EQ(fold.curves[0].low.at(0), -fold.curves[0].high.at(0));
  EXPECT_EQ(fold.curves[1].y_unit, "(m/s)²/Hz");
  EXPECT_EQ(fold.tables.size(), 1u);
}

}  // namespace
}  // namespace fathom
