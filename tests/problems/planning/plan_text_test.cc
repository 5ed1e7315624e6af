// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_text.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string SentenceOf(double before, double after) {
  ExperimentPlan plan;
  plan.message.clear();
  plan.duration = 60.0;
  plan.command.time = {0.0, 60.0};
  plan.command.value = {10.0, 0.0};
  PlannedParameter damping;
  damping.name = "quadratic_damping";
  damping.value = 10.0;
  damping.before = before;
  damping.after = after;
  damping.with_log_so_far = 0.5 * before;
  damping.sine = 2.0 * after;
  plan.parameters = {damping};
  return PlanSentence(PlanRequest(), plan);
}

TEST(PlanSentence, SaysWhatARunTellsMore) {
  EXPECT_THAT(SentenceOf(8.0, 2.0), HasSubstr("by this run alone"));
}

TEST(PlanSentence, PromisesNothingOfARunThatTellsLessThanIsKnown) {
  EXPECT_THAT(SentenceOf(2.0, 8.0), HasSubstr("less than what is known already"));
  EXPECT_THAT(SentenceOf(2.0, 8.0), Not(HasSubstr("by this run alone")));
}

std::string SentenceOfPair(double sigmas, double with_positions) {
  ExperimentPlan plan;
  plan.message.clear();
  plan.duration = 60.0;
  plan.separations = {{.truth = "thruster_lag",
                       .assumed = "sensor_lag",
                       .sigmas = sigmas,
                       .sine = 0.5,
                       .with_positions = with_positions}};
  return PlanSentence(PlanRequest(), plan);
}

TEST(PlanSentence, AdvisesPositionsWhereTheyDecideAndVelocitiesDoNot) {
  EXPECT_THAT(SentenceOfPair(0.3, 42.0), HasSubstr("Log the position too"));
  EXPECT_THAT(SentenceOfPair(0.3, 42.0),
              HasSubstr("known to 0.02 m at each velocity, it tells all "
                        "of them apart at 42.0 sigma"));
  EXPECT_THAT(SentenceOfPair(0.3, 2.0), Not(HasSubstr("Log the position")));
  EXPECT_THAT(SentenceOfPair(6.0, std::nan("")), HasSubstr("All causes are told apart at 6.0"));
}

}  // namespace
}  // namespace fathom
