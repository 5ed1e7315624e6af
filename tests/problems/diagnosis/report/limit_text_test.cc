// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/limit_text.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <limits>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::EndsWith;

ExclusionLimit LimitOf(const char* effect, double low, double high) {
  return {.effect = FindEffect(effect),
          .setting = {},
          .label = effect,
          .is_told = true,
          .low = low,
          .high = high};
}

TEST(HowToReadLimits, SaysThatAWeakerEffectMayBeThere) {
  Diagnosis diagnosis;
  diagnosis.limits = {LimitOf("time_offset", -0.1, 0.2),
                      LimitOf("thrust_slew_limit", 10.0, std::numeric_limits<double>::infinity())};
  EXPECT_THAT(HowToReadLimits(diagnosis),
              EndsWith("a weaker effect, such as a shorter lag or a higher saturation. Effects of "
                       "several parameters are not listed."));
}

// An offset of 0.288 to 0.335 s, and none but these.
TEST(HowToReadLimits, SaysWhatItMeansThatNoEffectIsRuledOutToo) {
  Diagnosis diagnosis;
  diagnosis.limits = {LimitOf("time_offset", 0.288, 0.335), LimitOf("thruster_lag", 0.0, 0.7)};
  Candidate& candidate = diagnosis.candidates.emplace_back();
  candidate.label = "time_offset";
  candidate.gain = 54.2;
  candidate.outcome = CandidateOutcome::kNoBetterThanRefused;
  EXPECT_THAT(HowToReadLimits(diagnosis),
              EndsWith(" Some rows rule out 'no effect' as well: taken alone, the effect fits "
                       "better than none. One row in twenty does so by chance, and more do "
                       "where the model lacks something else. None of them is named: "
                       "time_offset (dropped: gain 54, no better than what was refused)."));
  // One that could not have been seen rules out nothing.
  diagnosis.limits.front().is_told = false;
  EXPECT_THAT(HowToReadLimits(diagnosis), EndsWith("are not listed."));
}

}  // namespace
}  // namespace fathom
