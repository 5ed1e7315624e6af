// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/manoeuvre_page.h"
#include "fathom/manoeuvres/manoeuvre_prediction.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "error_from.h"
#include "steered_log.h"
#include <Eigen/Core>
#include <gmock/gmock.h>

namespace fathom {
namespace {

constexpr double kMass = 300.0, kDragOfSurge = 20.0, kStdOfMass = 15.0;

// Surge, sway and yaw, the inertia of surge known to 5 %.
FittedCoupledModel BoatModel() {
  FittedCoupledModel fitted;
  CoupledModel& model = fitted.model;
  model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  model.inertia.diagonal() << kMass, 400.0, 1.0, 1.0, 1.0, 200.0;
  model.quadratic_damping(0, 0) = kDragOfSurge;
  model.linear_damping(1, 1) = 200.0;
  model.linear_damping(5, 5) = 100.0;
  model.fin_force = {{"rudder", 30.0}};
  fitted.entries = {InertiaEntry(Dof::kSurge, Dof::kSurge)};
  fitted.covariance = Eigen::MatrixXd::Constant(1, 1, kStdOfMass * kStdOfMass);
  return fitted;
}

Log DrivenLog(const std::string& size, double ahead) {
  Log log = SteeredLog(size);
  log.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  std::ranges::fill(log.command->values[0], ahead);
  log.velocity->columns = {"u", "v", "r"};
  log.velocity->values.insert(log.velocity->values.begin() + 1,
                              std::vector<double>(log.velocity->time.size(), 0.0));
  return log;
}

// The reach grows with the mass alone, in proportion.
TEST(PredictManoeuvre, StopsWithTheIntervalOfTheMass) {
  const ManoeuvrePrediction report = PredictManoeuvre(
      BoatModel(), DrivenLog("size: [4, 1, 0.5]\n", 40.0), ParseManoeuvre("stop"), {400, 1});
  const double U = kAheadOfSteeredLog;
  const double reach = kMass / (2.0 * kDragOfSurge) * std::log(1.0 + kDragOfSurge * U * U / 40.0);
  const PredictedFigure& found = report.figures.front();
  EXPECT_EQ(found.figure.name, "track_reach");
  EXPECT_NEAR(found.figure.value, reach, 0.01 * reach);
  const double width = 2.0 * 1.96 * kStdOfMass / kMass * reach;
  EXPECT_NEAR(found.high - found.low, width, 0.15 * width);
  EXPECT_EQ(found.limit, 60.0);
  EXPECT_EQ(report.drawn.size(), 400u);
  EXPECT_EQ(GearSentence(report), "");
  EXPECT_TRUE(report.sentences.empty());
  FittedCoupledModel pushed = BoatModel();
  pushed.model.offset[0] = -12.0;
  const ManoeuvrePrediction doubted =
      PredictManoeuvre(pushed, DrivenLog("", 40.0), ParseManoeuvre("stop"), {});
  ASSERT_EQ(doubted.sentences.size(), 1u);
  EXPECT_THAT(doubted.sentences.front(), testing::HasSubstr("pushes ahead with 12 N"));
}

std::string Refusal(const FittedCoupledModel& model, const Log& log, const char* manoeuvre) {
  return ErrorFrom([&] { PredictManoeuvre(model, log, ParseManoeuvre(manoeuvre), {}); });
}

TEST(PredictManoeuvre, RefusesAStopThatNothingDrives) {
  EXPECT_THAT(Refusal(BoatModel(), DrivenLog("", 0.0), "stop"),
              testing::HasSubstr("no propulsion: its mean force ahead is 0"));
  FittedCoupledModel yaw = BoatModel();
  yaw.model.dofs = {Dof::kYaw};
  EXPECT_THAT(Refusal(yaw, DrivenLog("", 5.0), "stop"),
              testing::HasSubstr("the model moves no surge"));
}

TEST(PredictManoeuvre, RefusesToSteerWithoutARudder) {
  Log log = DrivenLog("", 40.0);
  log.fins.reset();
  for (const char* steered : {"zigzag:10/10", "turning_circle:35"}) {
    EXPECT_THAT(Refusal(BoatModel(), log, steered),
                testing::HasSubstr("no fin turns the vehicle, expected a rudder"));
  }
}

TEST(PredictManoeuvre, SaysThatAStableVehicleHoldsItsTrack) {
  const ManoeuvrePrediction report =
      PredictManoeuvre(BoatModel(), DrivenLog("", 40.0), ParseManoeuvre("pull_out"), {10, 1});
  ASSERT_EQ(report.sentences.size(), 1u);
  EXPECT_THAT(report.sentences.front(), testing::StartsWith("Stable: "));
  EXPECT_THAT(report.sentences.front(), testing::HasSubstr("10 of 10 drawn models say the same."));
  EXPECT_TRUE(report.drawn.empty());
}

TEST(GearSentence, SaysThatStepsOfALogAreNoSteeringGear) {
  ManoeuvrePrediction report;
  report.manoeuvre = ParseManoeuvre("turning_circle:35");
  report.track.time = {0.0};
  report.rudder_rate = 0.5;
  EXPECT_EQ(GearSentence(report), "The rudder turns at 28.6 deg/s.");
  report.rudder_rate = 3.5;
  EXPECT_THAT(GearSentence(report), testing::HasSubstr("A real steering gear is slower"));
}

TEST(NoIntervalSentence, SaysWhyAFigureHasNone) {
  ManoeuvrePrediction report;
  report.num_draws = 200;
  report.figures = {{.figure = {.name = "advance", .value = 19.0, .unit = "m"}, .low = 18.0}};
  EXPECT_EQ(NoIntervalSentence(report), "");
  report.figures.front().low = std::nan("");
  EXPECT_THAT(NoIntervalSentence(report), testing::HasSubstr("of the 200 drawn models"));
  report.num_draws = 0;
  EXPECT_EQ(NoIntervalSentence(report), "");
}

TEST(BeyondTheLogSentence, SaysHowFarTheRudderOfTheLogGoes) {
  ManoeuvrePrediction report;
  report.manoeuvre = ParseManoeuvre("turning_circle:35");
  report.logged_angle = 0.6;
  EXPECT_EQ(BeyondTheLogSentence(report), "");
  report.logged_angle = 0.35;
  EXPECT_THAT(BeyondTheLogSentence(report),
              testing::StartsWith("The log's rudder goes to 20.1 degrees."));
  report.manoeuvre = ParseManoeuvre("stop");
  EXPECT_EQ(BeyondTheLogSentence(report), "");
}

// A given delay takes the place of the log's and is said.
TEST(PredictManoeuvre, TakesTheRuddersDelayThatIsGiven) {
  const auto overshoot = [&](double delay) {
    const ManoeuvrePrediction report = PredictManoeuvre(
        BoatModel(), DrivenLog("", 40.0), ParseManoeuvre("zigzag:10/10"), {0, 1}, delay);
    EXPECT_EQ(report.rudder_delay, delay);
    EXPECT_THAT(GearSentence(report), testing::HasSubstr(delay > 0.0 ? "0.50 s" : "0.00 s"));
    return report.figures.front().figure.value;
  };
  EXPECT_GT(overshoot(0.5), overshoot(0.0));
}

// Dashes alone would leave it open.
TEST(PredictManoeuvre, SaysWhyThereAreNoFigures) {
  const auto sentence = [](const FittedCoupledModel& model, const char* manoeuvre) {
    const ManoeuvrePrediction report =
        PredictManoeuvre(model, DrivenLog("", 40.0), ParseManoeuvre(manoeuvre), {0, 1});
    return report.sentences.empty() ? "" : report.sentences.front();
  };
  EXPECT_EQ(sentence(BoatModel(), "zigzag:10/10"), "");
  EXPECT_THAT(sentence(BoatModel(), "zigzag:0.2/0.1"),
              testing::ContainsRegex("^No figures: within the .* deg to port; an overshoot counts "
                                     "only where the heading then comes back by more than 0.5 "
                                     "deg.$"));
  FittedCoupledModel sluggish = BoatModel();
  sluggish.model.inertia(5, 5) = 1e8;
  EXPECT_THAT(sentence(sluggish, "zigzag:-10/10"),
              testing::ContainsRegex(
                  "^No figures: within the 600 s .* deg to port, short of the order of 10 deg"));
  EXPECT_THAT(sentence(sluggish, "turning_circle:35"),
              testing::ContainsRegex("^No figures: .* turned by .* need 90 deg"));
  FittedCoupledModel gliding = BoatModel();
  gliding.model.quadratic_damping(0, 0) = 0.01;
  EXPECT_THAT(sentence(gliding, "stop:0"),
              testing::ContainsRegex("^No figures: .* did not stop: its speed ahead is still "));
}

TEST(ManoeuvrePage, ShowsTrackFiguresAndLimits) {
  const ManoeuvrePrediction report = PredictManoeuvre(BoatModel(),
                                                      DrivenLog("size: [4, 1, 0.5]\n", 40.0),
                                                      ParseManoeuvre("turning_circle:35"),
                                                      {40, 1});
  const Page page = ManoeuvrePage(report, "turning_circle:35", "run");
  ASSERT_EQ(page.sections.size(), 2u);
  const PlanPanel& plan = page.sections.front().plan_panels.at(0);
  EXPECT_EQ(plan.curve.ahead.size(), report.track.time.size());
  EXPECT_NEAR(static_cast<double>(plan.others.size()), 38.0, 1.0);
  ASSERT_EQ(plan.limits.size(), 2u);
  EXPECT_EQ(plan.limits[0].at, 18.0);
  EXPECT_EQ(plan.limits[1].at, 20.0);
  EXPECT_THAT(page.lead.front(), testing::HasSubstr("tactical diameter"));
  EXPECT_EQ(page.sections.back().tables.front().rows.size(), report.figures.size());
}

}  // namespace
}  // namespace fathom
