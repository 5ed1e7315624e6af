// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/log_prediction.h"

#include "fathom/base/input_error.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;

// A body of 2 kg without damping, pushed by 4 N: v = v0 + 2 t.
FittedModel PushedBody() {
  FittedModel model;
  model.force_unit = "N";
  model.model = {2.0, 0.0, 0.0, 0.0};
  return model;
}

// Twelve samples at 10 Hz from `from` on, of a body that had v0 there.
void AddRun(double from, double v0, Log* log) {
  for (int i = 0; i < 12; ++i) {
    log->velocity->time.push_back(from + 0.1 * i);
    log->velocity->values[0].push_back(v0 + 0.2 * i);
  }
}

// Two runs with a silence between them, the second of which is 0.25 m/s too slow in its last
// sample.
Log PushedLog() {
  Log log;
  log.command = Stream{.time = {0.5, 1.0}, .columns = {"tau_surge"}, .values = {{4.0, 4.0}}};
  log.velocity = Stream{.time = {}, .columns = {"u"}, .values = {{}}};
  AddRun(1.0, 0.5, &log);
  AddRun(40.0, 3.0, &log);
  log.velocity->values[0].back() -= 0.25;
  return log;
}

TEST(PredictLog, StartsAnewAfterASilence) {
  const auto prediction = PredictLog(PushedBody(), PushedLog());
  ASSERT_TRUE(prediction);
  ASSERT_EQ(prediction->segments.size(), 2u);
  EXPECT_THAT(prediction->parts, ElementsAre(LogPart::kTrain, LogPart::kTrain));
  EXPECT_NEAR(prediction->velocity[0].back(), 0.5 + 2.2, 1e-9);
  // The last sample is far from the others, and the start passes over it.
  EXPECT_NEAR(prediction->velocity[1].front(), 3.0, 1e-9);
  EXPECT_NEAR(prediction->figures.mae, 0.25 / 24.0, 1e-9);
  EXPECT_NEAR(prediction->figures.duration, 2.2, 1e-9);
}

TEST(PredictLog, TellsTrainingAndHeldOutDataApart) {
  Log log = PushedLog();
  log.held_out = {{.from = 39.0, .to = 50.0}};
  const auto prediction = PredictLog(PushedBody(), log);
  ASSERT_TRUE(prediction);
  EXPECT_THAT(prediction->parts, ElementsAre(LogPart::kTrain, LogPart::kHeldOut));
  EXPECT_NEAR(prediction->train.mae, 0.0, 1e-9);
  EXPECT_NEAR(prediction->held_out.mae, 0.25 / 12.0, 1e-9);
}

TEST(PredictLog, PredictsButDoesNotScoreWhatCameBeforeTheFirstCommand) {
  Log log = PushedLog();
  log.command->time = {39.0, 40.0};
  const auto prediction = PredictLog(PushedBody(), log);
  ASSERT_TRUE(prediction);
  EXPECT_THAT(prediction->parts, ElementsAre(LogPart::kOutside, LogPart::kTrain));
  EXPECT_EQ(prediction->figures.num_samples, 12);
}

TEST(PredictLog, ShowsWhatTheSensorWouldShow) {
  FittedModel model = PushedBody();
  model.effects = {{FindEffect("sensor_bias"), {.dof = Dof::kSurge}, {0.2}}};
  const auto prediction = PredictLog(model, PushedLog());
  ASSERT_TRUE(prediction);
  // The start too is what the sensor showed.
  EXPECT_NEAR(prediction->velocity[0].back(), 2.7, 1e-9);
}

TEST(PredictLog, StartsFromRestAtTheCommandsStampsWithoutMotion) {
  Log log = PushedLog();
  log.velocity.reset();
  const auto prediction = PredictLog(PushedBody(), log);
  ASSERT_TRUE(prediction);
  EXPECT_THAT(prediction->velocity[0], ElementsAre(0.0, DoubleEq(1.0)));
  EXPECT_THAT(prediction->parts, ElementsAre(LogPart::kOutside));
  EXPECT_TRUE(std::isnan(prediction->figures.mae));
}

TEST(PredictLog, IsNothingWhereTheRunDivergesAndRefusesAnotherUnit) {
  FittedModel model = PushedBody();
  model.model.linear_damping = -900.0;
  EXPECT_FALSE(PredictLog(model, PushedLog()));
  model.force_unit = "A";
  EXPECT_THROW(PredictLog(model, PushedLog()), InputError);
}

}  // namespace
}  // namespace fathom
