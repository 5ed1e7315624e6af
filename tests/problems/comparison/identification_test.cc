// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/identification.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// 1 m/s for 50 samples, then `later` for 50, under no force.
Segment TwoSpeeds(double later) {
  Segment segment;
  for (int i = 0; i < 100; ++i) {
    segment.time.push_back(0.1 * i);
    segment.velocity.push_back(i < 50 ? 1.0 : later);
  }
  segment.command = {{0.0}, {0.0}};
  segment.initial_velocity = 1.0;
  return segment;
}

// A model without damping goes on at 1 m/s: its NMAE is (1 - later) / (1 + later).
FittedModel Scored(const std::vector<Segment>& train, const std::vector<Segment>& held_out) {
  Signals signals;
  signals.train = train;
  signals.held_out = held_out;
  FittedModel fitted;
  fitted.model = {.inertia = 10.0, .quadratic_damping = 0.0, .linear_damping = 0.0};
  ScoreByFreeRuns(signals, &fitted);
  return fitted;
}

TEST(ScoreByFreeRuns, CallsAFitPoorAboveAnNmaeOfThreeTenthsAndSaysWhatToDo) {
  const FittedModel good = Scored({TwoSpeeds(0.6)}, {});
  EXPECT_NEAR(good.train.nmae, 0.25, 1e-12);
  EXPECT_THAT(good.caveats, IsEmpty());
  const FittedModel poor = Scored({TwoSpeeds(0.5)}, {});
  EXPECT_NEAR(poor.train.nmae, 1.0 / 3.0, 1e-12);
  EXPECT_THAT(poor.caveats,
              ElementsAre(AllOf(HasSubstr("The fit is poor"),
                                HasSubstr("misses 33 % of the motion"),
                                HasSubstr("run fathom_diagnose"))));
}

TEST(ScoreByFreeRuns, SaysThatAModelExplainsAlmostNothing) {
  EXPECT_THAT(Scored({TwoSpeeds(0.1)}, {}).caveats,
              ElementsAre(AllOf(HasSubstr("82 % of the motion"), HasSubstr("almost nothing"))));
}

TEST(ScoreByFreeRuns, SaysThatOnlyTheHeldOutPredictionIsPoor) {
  EXPECT_THAT(Scored({TwoSpeeds(0.9)}, {TwoSpeeds(0.4)}).caveats,
              ElementsAre(HasSubstr("misses 43 % of the held-out motion")));
}

}  // namespace
}  // namespace fathom
