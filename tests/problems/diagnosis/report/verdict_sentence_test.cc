// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/verdict_sentence.h"

#include <cmath>
#include <limits>

#include "handmade_diagnosis.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(VerdictSentence, OfAConsistentLog) {
  EXPECT_EQ(VerdictSentence(ConsistentDiagnosis()),
            "This log shows no error of your surge model beyond noise. The velocity NMAE on "
            "held-out data "
            "is 0.12.");
}

// The half interval of the width is 1.96 * 0.17 = 0.33 N: one decimal,
// from 7.67 to 8.33. That of the inertia is 11.6 kg, which starts with a 1: to the kilogram.
TEST(VerdictSentence, SaysHowMuchOfTheMotionAConsistentModelMisses) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.extended.train.nmae = 0.33;
  EXPECT_THAT(
      VerdictSentence(diagnosis),
      HasSubstr("beyond noise. But the noise is large: simulated from the command alone, the "
                "model misses up to 33 % of the motion."));
}

// The next step is to use the model without it.
TEST(VerdictSentence, ClaimsNoCauseThatTheHeldOutDataContradict) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.held_out_gain = -0.02;
  diagnosis.held_out_gain_low = -0.05;
  EXPECT_NE(VerdictSentence(diagnosis).find(" may come from "), std::string::npos);
  EXPECT_EQ(VerdictSentence(diagnosis).find(" comes from "), std::string::npos);
}

TEST(VerdictSentence, OfAnExplainedLog) {
  EXPECT_EQ(
      VerdictSentence(ExplainedDiagnosis()),
      "70 % of the error of your surge model that is not noise comes from a thruster dead zone "
      "(thrust_dead_zone), width 8.0 N (7.7 to 8.3 N). With it in the model, the velocity NMAE on "
      "held-out data falls from 0.12 to 0.080 (a gain of 32 %; 95 % interval 23 to 37 %), "
      "and the inertia changes from 1086 to 852 kg.");
}

// 0.4963 +- 1.96 * 0.0077 is 0.4812 to 0.5114, and 0.0151 starts with a 1.
TEST(VerdictSentence, OfAnAmbiguousLog) {
  EXPECT_EQ(
      VerdictSentence(AmbiguousDiagnosis()),
      "70 % of the error of your surge model that is not noise comes from a lag of the velocity "
      "measurement, "
      "as smoothing causes it (sensor_lag), time constant 0.496 s (0.481 to 0.511 s), or "
      "from a lag of the thrusters (thruster_lag). This log cannot tell sensor_lag from "
      "thruster_lag. To decide: large steps, to speeds where quadratic drag matters (in "
      "linear drag lags commute). With sensor_lag in the model, the velocity NMAE on held-out data "
      "falls from 0.12 to 0.080 (a gain of 32 %; 95 % interval 23 to 37 %), and the inertia "
      "changes from 1086 to 852 kg.");
}

// Three times the scatter and more is no noise that anyone would expect.
TEST(VerdictSentence, SaysThatConsistentSaysLittleWhereTheErrorIsWellAboveTheScatter) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.wander_ratio = 5.1;
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("The error is 5 times the scatter from sample to sample."));
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("It is noise, or its cause is not in the log: here `consistent` does not "
                        "mean that the model is right."));
  diagnosis.wander_ratio = 2.9;
  EXPECT_EQ(VerdictSentence(diagnosis), VerdictSentence(ConsistentDiagnosis()));
}

TEST(VerdictSentence, SaysThatRedDataMakeAWrongModel) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.verdict = Verdict::kUnexplained;
  diagnosis.is_only_red = true;
  EXPECT_THAT(
      VerdictSentence(diagnosis),
      HasSubstr("But the red findings say that the data are wrong, and then so is the model."));
}

TEST(VerdictSentence, SaysThatASearchWhichWasCutMayHaveMissedCauses) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.verdict = Verdict::kUnexplained;
  diagnosis.is_only_cut = true;
  EXPECT_THAT(VerdictSentence(diagnosis),
              EndsWith("The rest of the error is noise, but the search was ended before it was "
                       "through: other causes may do as well."));
}

TEST(VerdictSentence, SaysWhatFitsBestAndWhyItIsNotNamed) {
  Diagnosis diagnosis = UnexplainedDiagnosis();
  diagnosis.not_named = {"coulomb_friction", "the error on held-out data grows by 12 %"};
  EXPECT_EQ(
      VerdictSentence(diagnosis),
      "Part of the error of your surge model is not noise. It fits best with "
      "coulomb_friction, but the error on held-out data grows by 12 %: no cause is named. The "
      "velocity NMAE on held-out data is 0.12.");
}

// A spring that hardens: what the linear one leaves goes with the cube of the displacement.
TEST(VerdictSentence, SaysWhatTheMissingForceFollows) {
  Diagnosis diagnosis = UnexplainedDiagnosis();
  MissingForce& missing = diagnosis.missing_force = {};
  for (int i = 0; i < 2000; ++i) {
    const double x = std::sin(0.01 * i);
    missing.time.push_back(0.1 * i);
    missing.displacement.push_back(x);
    missing.velocity.push_back(std::cos(0.01 * i));
    missing.mean.push_back(20.0 * x + 30.0 * x * x * x);
    missing.explained.push_back(20.0 * x);
  }
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("The missing force follows the displacement, which explains "));
  missing.explained = missing.mean;
  EXPECT_THAT(VerdictSentence(diagnosis), Not(HasSubstr("follows")));
  missing.explained.assign(missing.mean.size(), 0.0);
  // Time is followed by any slow force.
  missing.displacement.clear();
  missing.velocity.clear();
  EXPECT_THAT(VerdictSentence(diagnosis), Not(HasSubstr("follows")));
}

TEST(VerdictSentence, OfAnUnexplainedLog) {
  EXPECT_EQ(VerdictSentence(UnexplainedDiagnosis()),
            "Part of the error of your surge model is not noise, and no effect in the catalogue "
            "explains it. The velocity NMAE on held-out data is 0.12.");
}

TEST(VerdictSentence, IsItsParagraphs) {
  const auto paragraphs = VerdictParagraphs(AmbiguousDiagnosis());
  EXPECT_THAT(paragraphs,
              ElementsAre(StartsWith("70 % of the error"),
                          StartsWith("This log cannot tell sensor_lag"),
                          StartsWith("With sensor_lag in the model, the velocity NMAE")));
  EXPECT_EQ(VerdictSentence(AmbiguousDiagnosis()),
            paragraphs[0] + " " + paragraphs[1] + " " + paragraphs[2]);
}

TEST(VerdictSentence, SaysThatACauseMayBeACoincidence) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.verdict = Verdict::kUnexplained;
  diagnosis.coincidence = {.label = "thrust_dead_zone", .input = "displacement"};
  EXPECT_THAT(
      VerdictSentence(diagnosis),
      EndsWith(" kg. A free function of the displacement explains these data about as well "
               "as thrust_dead_zone. The cause may be one that the catalogue does not have."));
  EXPECT_THAT(VerdictSentence(diagnosis), Not(HasSubstr("still more than noise")));
}

TEST(VerdictSentence, SaysThatSomethingIsLeftBesideTheCauses) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.verdict = Verdict::kUnexplained;
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr(" kg. The remaining error is still more than noise, and no effect in the "
                        "catalogue explains it. What is named may only have a shape like the true "
                        "cause's."));
}

TEST(VerdictSentence, CallsALossALossAndWarns) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.extended.held_out.nmae = 0.157;
  diagnosis.held_out_gain = -0.34;
  diagnosis.held_out_gain_low = -0.71;
  diagnosis.held_out_gain_high = -0.012;
  EXPECT_THAT(
      VerdictSentence(diagnosis),
      HasSubstr("velocity NMAE on held-out data rises from 0.12 to 0.16 (a loss of 34 %; 95 % "
                "interval 1 to 71 %)"));
  EXPECT_THAT(
      VerdictSentence(diagnosis),
      HasSubstr("On data that no fit has seen, this model is worse than the one without: do "
                "not rely on it."));
  EXPECT_THAT(VerdictSentence(ExplainedDiagnosis()), Not(HasSubstr("do not rely")));
}

TEST(VerdictSentence, CountsLogsAndCauses) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.logs = {"tank_07", "tank_08"};
  AddCause("steady_current", {0.05}, {0.002}, &diagnosis);
  EXPECT_THAT(VerdictSentence(diagnosis),
              StartsWith("70 % of the error of your surge model that is not noise has two causes: "
                         "a thruster dead zone "
                         "(thrust_dead_zone), width 8.0 N (7.7 to 8.3 N); a steady current "
                         "(steady_current), "));
  EXPECT_THAT(VerdictSentence(diagnosis), HasSubstr("With them in the model, the velocity NMAE"));
  diagnosis.causes[0].alternatives = AlternativesNamed({"thrust_curve"});
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("These 2 logs cannot tell thrust_dead_zone from thrust_curve."));
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("(7.7 to 8.3 N), or a thrust curve other than the assumed one "
                        "(thrust_curve); a steady current"));
  Diagnosis consistent = ConsistentDiagnosis();
  consistent.logs = diagnosis.logs;
  EXPECT_THAT(VerdictSentence(consistent), StartsWith("These 2 logs show no error"));
}

TEST(VerdictSentence, ListsManyAlternativesOnce) {
  Diagnosis diagnosis = AmbiguousDiagnosis();
  diagnosis.causes[0].alternatives =
      AlternativesNamed({"thruster_lag", "time_offset", "thrust_curve"});
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr(", or from one of thruster_lag, time_offset, thrust_curve."));
  diagnosis.causes[0].alternatives = AlternativesNamed(
      {"thruster_lag", "time_offset", "thrust_curve", "fluid_memory", "thrust_fade"});
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("comes from an effect of the actuator or in the water or of the sensor: a "
                        "lag of the velocity measurement"));
  EXPECT_THAT(
      VerdictSentence(diagnosis),
      HasSubstr(" fits best, and 5 others fit as well. This log cannot tell sensor_lag "
                "from any of thruster_lag, time_offset, thrust_curve, fluid_memory, thrust_fade."));
}

TEST(VerdictSentence, SaysWhereASizeIsABoundAndNoEstimate) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  AddCause("thrust_asymmetry", {-1.0}, {0.0}, &diagnosis);
  EXPECT_THAT(VerdictSentence(diagnosis), HasSubstr("reverse loss -1.000 (its physical bound)"));
}

TEST(VerdictSentence, SaysOnWhichDataItGains) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.by_left_out_blocks = true;
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("With it in the model, the cross-validated velocity NMAE falls"));
  diagnosis.baseline.held_out.nmae = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("(7.7 to 8.3 N). The inertia changes from 1086 to 852 kg."));
}

TEST(VerdictSentence, SaysOfWhatActsOnThePosesAloneHowThePosesAreTold) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.gain_is_in_poses = true;
  diagnosis.held_out_gain = 0.24;
  diagnosis.held_out_gain_low = 0.15;
  diagnosis.held_out_gain_high = 0.32;
  EXPECT_THAT(
      VerdictSentence(diagnosis),
      HasSubstr(
          "This acts on the poses only: with it in the model, their motion within 10 s is "
          "predicted better on held-out data (a gain of 24 %; 95 % interval 15 to 32 %), and "));
  diagnosis.held_out_gain = -0.004;
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("is predicted as before on held-out data (a loss of 0 %"));
}

// What stays within its interval does not move: it is not worth a word.
TEST(VerdictSentence, NamesNoParameterThatDoesNotMove) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.extended.model.baseline = diagnosis.baseline.model.baseline;
  EXPECT_THAT(VerdictSentence(diagnosis), Not(HasSubstr("changes")));
}

// Of the accelerations of the run, 0.1 and 0.2 m/s^2, 20 kg are a few newton; of its speeds, up to
// 0.4 m/s, 30 kg/s are more.
TEST(VerdictSentence, NamesTheParameterThatCarriesMostForce) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.extended.model.baseline.inertia = 1066.0;
  diagnosis.extended.covariance(0, 0) = 1.0;
  diagnosis.extended.model.baseline.linear_damping = 19.9;
  EXPECT_THAT(VerdictSentence(diagnosis),
              HasSubstr("and the linear damping changes from 49.9 to 19.9 kg/s."));
}

}  // namespace
}  // namespace fathom
