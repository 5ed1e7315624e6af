// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/candidate_text.h"

#include <string>

#include <gtest/gtest.h>

namespace fathom {
namespace {

std::string TextOf(CandidateOutcome outcome) {
  Candidate candidate;
  candidate.score = 2.04;
  candidate.gain = 60.2;
  candidate.noise_reach = 11.2;
  candidate.outcome = outcome;
  return WhyText(candidate);
}

TEST(WhyText, SaysWithItsNumbersWhyACandidateWasKeptOrDropped) {
  EXPECT_EQ(TextOf(CandidateOutcome::kKept), "kept: gain 60; noise alone reaches 11.2");
  EXPECT_EQ(TextOf(CandidateOutcome::kScoreWithinNoise),
            "dropped: score 2.0; noise alone reaches 11.2");
  EXPECT_EQ(TextOf(CandidateOutcome::kOthersScoreHigher),
            "not refitted: score 2.0; others score higher");
  EXPECT_EQ(TextOf(CandidateOutcome::kGainWithinNoise),
            "dropped: gain 60.2; noise alone reaches 11.2");
  EXPECT_EQ(TextOf(CandidateOutcome::kAlternative), "these logs cannot tell it from a kept cause");
  EXPECT_EQ(TextOf(CandidateOutcome::kNeedless),
            "dropped: helps alone (gain 60), adds nothing once the kept causes are in");
  EXPECT_EQ(TextOf(CandidateOutcome::kRefused),
            "refused: gain 60, but free runs do not improve by it");
  EXPECT_EQ(TextOf(CandidateOutcome::kNoBetterThanRefused),
            "dropped: gain 60, no better than what was refused");
  EXPECT_EQ(TextOf(CandidateOutcome::kTakenUpByNoise),
            "dropped: gain 60, but the noise learned without it takes it up");
}

TEST(NonePassesText, SaysWhatBecameOfTheBest) {
  Diagnosis diagnosis;
  EXPECT_EQ(NonePassesText(diagnosis), "");
  diagnosis.candidates.resize(2);
  Candidate& best = diagnosis.candidates.front();
  best.label = "thruster_lag";
  best.gain = 3.04;
  best.noise_reach = 8.1;
  best.outcome = CandidateOutcome::kGainWithinNoise;
  EXPECT_EQ(NonePassesText(diagnosis),
            "No candidate passes, of 2 tried. The best is thruster_lag (dropped: gain 3.0; noise "
            "alone reaches 8.1). The gain is twice the log-likelihood that the effect adds.");
  diagnosis.causes.emplace_back();
  EXPECT_EQ(NonePassesText(diagnosis), "");
}

}  // namespace
}  // namespace fathom
