// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/log_prediction.h"

#include "fathom/base/input_error.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

Log PushedLog() {
  Log log;
  log.command = {.time = {0.5, 1.0}, .columns = {"tau_surge"}, .values = {{4.0, 4.0}}};
  log.velocity = {.time = {1.0, 2.0, 40.0, 40.5}, .columns = {"u"}, .values = {{0.5, 2, 3, 4}}};
  return log;
}

TEST(PredictLog, StartsAnewAfterASilence) {
  const auto prediction = PredictLog(PushedBody(), PushedLog());
  ASSERT_TRUE(prediction);
  ASSERT_EQ(prediction->segments.size(), 2u);
  EXPECT_THAT(prediction->velocity[0], ElementsAre(DoubleEq(0.5), DoubleEq(2.5)));
  EXPECT_THAT(prediction->velocity[1], ElementsAre(DoubleEq(3.0), DoubleEq(4.0)));
  EXPECT_DOUBLE_EQ(prediction->figures.mae, 0.5 / 4.0);
  EXPECT_DOUBLE_EQ(prediction->figures.duration, 1.5);
}

TEST(PredictLog, ShowsWhatTheSensorWouldShow) {
  FittedModel model = PushedBody();
  model.effects = {{FindEffect("sensor_bias"), {.dof = Dof::kSurge}, {0.2}}};
  const auto prediction = PredictLog(model, PushedLog());
  ASSERT_TRUE(prediction);
  EXPECT_NEAR(prediction->velocity[0][1], 2.5, 1e-12);  // the start too is what the sensor showed
}

TEST(PredictLog, StartsFromRestAtTheCommandsStampsWithoutMotion) {
  Log log = PushedLog();
  log.velocity.reset();
  const auto prediction = PredictLog(PushedBody(), log);
  ASSERT_TRUE(prediction);
  EXPECT_THAT(prediction->velocity[0], ElementsAre(0.0, DoubleEq(1.0)));
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
