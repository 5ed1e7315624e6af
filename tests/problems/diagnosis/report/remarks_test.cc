// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/remarks.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

// One that leaves nothing to say.
Judgement Plain() {
  Judgement judgement;
  judgement.search.suspects = {{FindEffect("thruster_lag"), {}}, {FindEffect("sensor_bias"), {}}};
  judgement.evidence = {.inertia = 800.0, .inertia_std = 9.0, .share_left = 0.1};
  judgement.remaining.num_columns = 3;
  return judgement;
}

std::vector<std::string> RemarksOn(const Judgement& judgement, bool has_velocity = true) {
  return RemarksOnJudgement(judgement, has_velocity);
}

TEST(RemarksOnJudgement, AreNoneWhereThereIsNothingToSay) {
  EXPECT_THAT(RemarksOn(Plain()), IsEmpty());
}

TEST(RemarksOnJudgement, SayWhatWasRefusedAndWhyInItsOrder) {
  Judgement judgement = Plain();
  judgement.choice.refusals = {
      {.reason = Refusal::Reason::kFinerThanTheStamps, .refused = {0}},
      {.reason = Refusal::Reason::kLosesBesideOthers, .refused = {1}, .kept = {0}},
      {.reason = Refusal::Reason::kGainsNothing, .refused = {0}},
      {.reason = Refusal::Reason::kLosesOnUnseenData,
       .refused = {0, 1},
       .loss = {.value = -0.12, .low = -0.2, .high = -0.05}},
      {.reason = Refusal::Reason::kLosesInTraining,
       .refused = {0},
       .nmae_before = 0.25,
       .nmae_after = 0.31}};
  EXPECT_THAT(
      RemarksOn(judgement),
      ElementsAre(
          StartsWith("Not named: thruster_lag. It improves the fit, but it is under half of the "
                     "step between two samples"),
          "Not named beside thruster_lag: sensor_bias. It improves the fit, but with it the error "
          "on held-out data grows.",
          StartsWith("Not named: thruster_lag. It improves the fit, but it has no significant gain "
                     "on held-out data"),
          "Not named: thruster_lag with sensor_bias. It improves the fit, but the error on "
          "held-out data grows by 12 % (5 to 20 %).",
          "Not named: thruster_lag. It improves the fit, but the NMAE on the training data "
          "itself grows from 0.25 to 0.31."));
}

// The search weighs effects together, the table of candidates each alone.
TEST(NotNamedOf, NamesWhatIsRefusedInTheOrderOfTheCandidates) {
  const Judgement judgement = Plain();
  const auto not_named = [&](const std::vector<Refusal>& refusals) {
    std::vector<Candidate> candidates(3);
    candidates[0].label = "sensor_bias";
    candidates[1].label = "time_offset";
    candidates[2].label = "thruster_lag";
    return NotNamedOf(refusals, candidates, judgement.search.suspects);
  };
  const Refusal lag = {.reason = Refusal::Reason::kGainsNothing, .refused = {0}};
  const Refusal bias = {.reason = Refusal::Reason::kGainsNothing, .refused = {1}, .kept = {0}};
  EXPECT_EQ(not_named({lag}).label, "thruster_lag");
  EXPECT_THAT(not_named({lag}).why, StartsWith("it has no significant gain"));
  EXPECT_EQ(not_named({bias, lag}).label, "sensor_bias or thruster_lag");
  EXPECT_EQ(not_named({bias, lag}).why, "held-out data confirm none of them (the notes say why)");
  EXPECT_EQ(not_named({lag, lag}).label, "thruster_lag");
}

TEST(RemarksOnJudgement, SayHowFarTheDataCarryIt) {
  Judgement judgement = Plain();
  judgement.evidence.inertia_std = 900.0;
  judgement.remaining.num_columns = 0;
  EXPECT_THAT(RemarksOn(judgement, false),
              ElementsAre(HasSubstr("too few"),
                          HasSubstr("inertia is 800 with a standard deviation of 9e+02"),
                          HasSubstr("has poses but no velocities")));
  // Nothing is looked for where nothing is left: that it was not is no news.
  judgement.evidence = {.inertia = 800.0, .inertia_std = 9.0, .share_left = 4e-4};
  judgement.remaining.is_negligible = true;
  EXPECT_THAT(RemarksOn(judgement), ElementsAre(HasSubstr("misses 0.04 % of the motion")));
}

TEST(RemarksOnData, CountTheSamplesLeftOut) {
  MeasuredSegments segments;
  segments.remarks = {"first"};
  Preparation preparation;
  EXPECT_THAT(RemarksOnData(segments, preparation), ElementsAre("first"));
  preparation.num_outliers = 1;
  EXPECT_THAT(RemarksOnData(segments, preparation),
              ElementsAre("first", "Left out: 1 single outlier far from its neighbours."));
  preparation.num_outliers = 2;
  EXPECT_THAT(RemarksOnData(segments, preparation),
              ElementsAre("first", "Left out: 2 single outliers far from their neighbours."));
}

TEST(RemarksOnData, SayThatALongLogIsNotSearchedWhole) {
  Preparation preparation;
  preparation.duration = 36000.0;
  preparation.used = 3600.0;
  EXPECT_THAT(RemarksOnData({}, preparation),
              ElementsAre(StartsWith("Causes are searched for in 1 of the 10 h of training data")));
}

}  // namespace
}  // namespace fathom
