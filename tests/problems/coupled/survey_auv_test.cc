// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A few of the survey AUVs that survey_scores draws, held to the bars of docs/fins.md.

#include "survey_auv.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::IsEmpty;

TEST(SurveyAuv, IsCoveredByItsIntervalsAndPredictsUnseenManoeuvres) {
  int num_numbers = 0, num_covered = 0;
  for (const unsigned seed : {1u, 2u}) {
    const SurveyFit fit = FitSurvey(seed);
    ASSERT_TRUE(fit.is_usable) << fit.message;
    EXPECT_LT(fit.miss_ratio, 1.1);
    num_numbers += fit.num_numbers;
    num_covered += fit.num_covered;
  }
  // Of 76 numbers 95 %, give or take three standard deviations of 2.5 %; numbers of a vehicle
  // go together, so twice that.
  EXPECT_GE(num_covered, 0.8 * num_numbers);
}

// Whether a search names this fault and nothing else.
void ExpectNamedAlone(FinFault fault) {
  const SurveyNaming naming = NameFault(4, fault);
  EXPECT_TRUE(naming.is_right) << ::testing::PrintToString(naming.named);
  EXPECT_EQ(naming.num_false, 0) << ::testing::PrintToString(naming.named);
}

TEST(SurveyAuv, HasADeadFinThatIsNamed) { ExpectNamedAlone(FinFault::kDead); }

TEST(SurveyAuv, HasAStuckFinThatIsNamed) { ExpectNamedAlone(FinFault::kStuck); }

TEST(SurveyAuv, HasAFinThatIsNotStraightAndIsNamed) { ExpectNamedAlone(FinFault::kNeutral); }

TEST(SurveyAuv, HasASlowFinThatIsNamed) { ExpectNamedAlone(FinFault::kSlow); }

// The same, with an interval that holds the truth and is within a tenth of it.
void ExpectNamedAloneAs(FinFault fault, double truth) {
  const SurveyNaming naming = NameFault(4, fault);
  EXPECT_TRUE(naming.is_right) << ::testing::PrintToString(naming.named);
  EXPECT_EQ(naming.num_false, 0) << ::testing::PrintToString(naming.named);
  EXPECT_NEAR(naming.value, truth, 3.0 * naming.std);
  EXPECT_LT(naming.std, 0.1 * truth);
}

TEST(SurveyAuv, HasAFinOfALimitedRateThatIsNamed) {
  ExpectNamedAloneAs(FinFault::kLimited, kRateOfSurvey);
}

TEST(SurveyAuv, HasAFinThatStallsEarlyAndIsNamed) {
  ExpectNamedAloneAs(FinFault::kStalled, kStallOfSurvey);
}

TEST(SurveyAuv, ThatIsSoundHasNoFault) {
  EXPECT_THAT(NameFault(4, FinFault::kNone).named, IsEmpty());
}

}  // namespace
}  // namespace fathom
