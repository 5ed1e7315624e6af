// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/next_steps.h"

#include <limits>

#include "handmade_diagnosis.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(NextSteps, SayWhatToDoAboutACertainCause) {
  EXPECT_THAT(NextSteps(ExplainedDiagnosis()),
              ElementsAre("thrust_dead_zone: Look for the dead band of the speed controllers "
                          "around neutral and add it to the command."));
}

TEST(NextSteps, AskForTheDecidingExperimentFirst) {
  EXPECT_THAT(
      NextSteps(AmbiguousDiagnosis()),
      ElementsAre("First find out whether the cause is sensor_lag or thruster_lag. To "
                  "decide: large steps, to speeds where quadratic drag matters (in linear drag "
                  "lags commute).",
                  "If it is sensor_lag: Log the raw sensor, or reduce the smoothing of the "
                  "estimator.",
                  "If it is thruster_lag: Log the propellers' speed and use it in place "
                  "of the command."));
}

// One way to go: nothing asks to act on the cause before another log names it.
TEST(NextSteps, WaitForAnotherLogWhereTheHeldOutDataDoNotConfirm) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.held_out_gain_low = -0.01;
  EXPECT_THAT(NextSteps(diagnosis),
              ElementsAre("The held-out data do not confirm this cause: use the model without it "
                          "(that of fathom_identify) until another log names it too.",
                          HasSubstr("If another log names thrust_dead_zone too: Look for")));
  AddCause("thruster_lag", {0.4}, {0.01}, &diagnosis);
  EXPECT_THAT(NextSteps(diagnosis),
              ElementsAre("The held-out data do not confirm these causes: use the model without "
                          "them (that of fathom_identify) until another log names them too.",
                          HasSubstr("If another log names thrust_dead_zone too: "),
                          HasSubstr("If another log names thruster_lag too: ")));
}

TEST(NextSteps, ActOnACauseWhereNothingWasHeldOut) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.held_out_gain = std::numeric_limits<double>::quiet_NaN();
  diagnosis.held_out_gain_low = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(NextSteps(diagnosis), ElementsAre(StartsWith("thrust_dead_zone: Look for")));
  diagnosis.held_out_gain = -0.01;  // its interval is not known
  EXPECT_THAT(NextSteps(diagnosis), Contains(HasSubstr("do not confirm this cause")));
}

TEST(NextSteps, SayWhichDampingIsOpenAndHowToKnowIt) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.force_unit = "N";
  diagnosis.extended.model.baseline.quadratic_damping = 3.0;
  diagnosis.extended.covariance(kQuadraticDamping, kQuadraticDamping) = 4.0;
  EXPECT_EQ(NextSteps(diagnosis).back(),
            "These data leave open the quadratic damping (0 to 6.9 kg/m). Drive at several steady "
            "speeds before the model is used at other speeds.");
}

// A group must not hide what can never be decided behind "To decide:".
TEST(NextSteps, AdmitThatNoExperimentDecides) {
  Diagnosis diagnosis = AmbiguousDiagnosis();
  diagnosis.causes[0].experiment = {"No velocity log can decide, because the two are identical.",
                                    false};
  EXPECT_EQ(NextSteps(diagnosis).front(),
            "First find out whether the cause is sensor_lag or thruster_lag. No velocity log can "
            "decide, because the two are identical.");
}

// Advice on a dozen effects helps nobody: the experiment comes first.
TEST(NextSteps, LeaveTheAdviceOutWhereAlternativesAreMany) {
  Diagnosis diagnosis = AmbiguousDiagnosis();
  diagnosis.causes[0].alternatives = AlternativesNamed(
      {"thruster_lag", "time_offset", "thrust_curve", "fluid_memory", "thrust_fade"});
  EXPECT_THAT(
      NextSteps(diagnosis),
      ElementsAre(
          "First find out whether the cause is sensor_lag or any of "
          "thruster_lag, time_offset, thrust_curve, fluid_memory, thrust_fade. To decide: large "
          "steps, to speeds where quadratic drag matters (in linear drag lags "
          "commute)."));
}

TEST(NextSteps, SayWhatBelongsToTheRun) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  AddCause("steady_current", {0.05}, {0.002}, &diagnosis);
  EXPECT_EQ(NextSteps(diagnosis).back(),
            "steady_current holds for this run only: fathom_simulate leaves it out on any other "
            "log.");
}

TEST(NextSteps, SayWhatAVerdictWithoutCausesMeans) {
  EXPECT_THAT(NextSteps(ConsistentDiagnosis()),
              ElementsAre(HasSubstr("within the speeds and commands of these data")));
  EXPECT_THAT(NextSteps(UnexplainedDiagnosis()), ElementsAre(HasSubstr("adding_an_effect.md")));
}

TEST(NextSteps, DoNotAdviseAModelThatMissesAThirdOfTheMotion) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.extended.train.nmae = 0.33;
  EXPECT_THAT(NextSteps(diagnosis),
              ElementsAre(AllOf(StartsWith("Do not use the model as it is"),
                                HasSubstr("misses up to 33 % of the motion"))));
}

// 38 N, the whole thrust, were called a dropped payload.
TEST(NextSteps, DoNotCallAStepAsLargeAsTheThrustAPayload) {
  Diagnosis diagnosis = ConsistentDiagnosis();  // whose command is 36 N RMS
  diagnosis.verdict = Verdict::kExplained;
  AddCause("buoyancy_step", {38.0, 60.0}, {0.5, 0.2}, &diagnosis);
  EXPECT_THAT(NextSteps(diagnosis), Contains(HasSubstr("thrusters that stopped")));
  EXPECT_THAT(NextSteps(diagnosis), Not(Contains(HasSubstr("payload dropped"))));
  diagnosis.extended.model.effects[0].values[0] = 8.0;
  EXPECT_THAT(NextSteps(diagnosis), Contains(HasSubstr("payload dropped")));
}

}  // namespace
}  // namespace fathom
