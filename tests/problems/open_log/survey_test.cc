// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/open_log/survey.h"

#include "fathom/base/input_error.h"
#include "fathom/open_log/open_log.h"
#include "fathom/signal/signals.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>

#include "test_folder.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using Signal = std::function<double(double)>;

// A square wave with a period of 10 s [N], and the speed of 40 kg with 20 kg/s of damping under it.
double Square(double t) { return std::fmod(t, 10.0) < 5.0 ? 20.0 : -20.0; }
double Speed(double t) {
  const double in_half = std::fmod(t, 5.0);
  const double sign = Square(t) > 0.0 ? 1.0 : -1.0;
  // Between -a and a, with a = (1 - e) / (1 + e) and e = exp(-5 * 20 / 40), in steady state.
  const double a = std::tanh(1.25);
  return sign * (1.0 - (1.0 + a) * std::exp(-0.5 * in_half));
}

// A CSV with so many rows at 10 Hz.
Survey SurveyOf(int rows, const Signal& command, const Signal& speed) {
  const std::filesystem::path file = TestFolder() / "run.csv";
  std::ofstream out(file);
  out << "t,tau,v\n";
  for (int i = 0; i < rows; ++i) {
    out << fmt::format("{:.1f},{},{}\n", 0.1 * i, command(0.1 * i), speed(0.1 * i));
  }
  out.close();
  return SurveyLog(file, Dof::kSurge);
}

SurveyedDof OnlyDofOf(const Survey& survey) {
  EXPECT_EQ(survey.dofs.size(), 1u);
  return survey.dofs.empty() ? SurveyedDof{} : survey.dofs.front();
}

// What is held out on the command line counts, not only what log.yaml says.
TEST(Survey, KnowsWhatIsHeldOutOfALogThatWasOpened) {
  SurveyOf(601, Square, Speed);
  Log log = OpenLog(TestFolder() / "run.csv", {.dof = Dof::kSurge, .held_out = {{0.0, 60.0}}});
  EXPECT_EQ(OnlyDofOf(fathom::SurveyOf(std::move(log))).why_not, kAllIsHeldOut);
}

TEST(Survey, TakesARunUnderASquareWave) {
  const Survey survey = SurveyOf(601, Square, Speed);
  EXPECT_EQ(OnlyDofOf(survey).why_not, "");
  EXPECT_EQ(OnlyDofOf(survey).dof, Dof::kSurge);
  EXPECT_NEAR(survey.duration, 60.0, 1e-9);
  EXPECT_TRUE(std::isnan(survey.start));
  EXPECT_FALSE(survey.needs_tracking);
}

TEST(Survey, SeesRestAtAnySpeed) {
  // 0.1 has no mean of exactly 0.1.
  for (const double at : {0.0, 0.1, -0.25, 1e5}) {
    const SurveyedDof dof = OnlyDofOf(SurveyOf(601, Square, [&](double) { return at; }));
    EXPECT_EQ(dof.why_not, "at rest: the motion never changes.") << at;
    EXPECT_FALSE(dof.may_help);
  }
}

TEST(Survey, SeesThatThereIsOnlyNoise) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.02);
  const SurveyedDof dof = OnlyDofOf(SurveyOf(601, Square, [&](double) { return noise(random); }));
  EXPECT_EQ(dof.why_not, "at rest: the motion is no more than white noise.");
  EXPECT_FALSE(dof.may_help);
}

TEST(Survey, SeesThatASpeedIsSteady) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.1, 0.0002);
  const SurveyedDof dof = OnlyDofOf(SurveyOf(601, Square, [&](double) { return noise(random); }));
  EXPECT_EQ(dof.why_not, "steady: the speed is 0.1 m/s and white noise.");
  EXPECT_FALSE(dof.may_help);
}

TEST(Survey, SeesMotionInNoise) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1.0);  // the speed is at most 0.85
  EXPECT_EQ(
      OnlyDofOf(SurveyOf(601, Square, [&](double t) { return Speed(t) + noise(random); })).why_not,
      "");
}

TEST(Survey, TakesAConstantCommandOnlyTogetherWithOthers) {
  const SurveyedDof dof = OnlyDofOf(SurveyOf(
      601, [](double) { return 20.0; }, [](double t) { return 1.0 - std::exp(-0.5 * t); }));
  EXPECT_EQ(dof.why_not, "the command never changes: it is 20 N throughout.");
  EXPECT_TRUE(dof.may_help);
}

TEST(Survey, TakesNoLessThanThreeSeconds) {
  EXPECT_EQ(OnlyDofOf(SurveyOf(31, Square, Speed)).why_not.find("too short"), std::string::npos);
  const SurveyedDof dof = OnlyDofOf(SurveyOf(30, Square, Speed));
  EXPECT_EQ(dof.why_not, "too short: 30 samples over 2.9 s, expected at least 20 over 3 s.");
  EXPECT_FALSE(dof.may_help);
}

TEST(Survey, ComesBackFromItsText) {
  Survey survey;
  survey.dive = "dive \"1\"";
  survey.vehicle = "v";
  survey.duration = 12.5;
  survey.needs_tracking = true;
  survey.dofs = {{Dof::kYaw, "at rest", false}, {Dof::kHeave, "", true}};
  const Survey back = ParseSurvey(FormatSurvey(survey));
  EXPECT_EQ(back.dive, survey.dive);
  EXPECT_EQ(back.vehicle, "v");
  EXPECT_TRUE(std::isnan(back.start));
  EXPECT_EQ(back.duration, 12.5);
  EXPECT_TRUE(back.needs_tracking);
  ASSERT_EQ(back.dofs.size(), 2u);
  EXPECT_EQ(back.dofs[0].dof, Dof::kYaw);
  EXPECT_EQ(back.dofs[0].why_not, "at rest");
  EXPECT_TRUE(back.dofs[1].may_help);
}

TEST(Survey, RefusesAnotherText) {
  for (const char* text : {"",
                           "{",
                           "[]",
                           "3",
                           "{}",
                           "{\"dive\": 3}",
                           R"({"dive": "", "vehicle": "", "start": null, "duration": 1,
                               "needs_tracking": false,
                               "dofs": [{"dof": "up", "why_not": "", "may_help": true}]})"}) {
    EXPECT_THROW(ParseSurvey(text), InputError) << text;
  }
}

}  // namespace
}  // namespace fathom
