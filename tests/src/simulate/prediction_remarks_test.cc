// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/prediction_remarks.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Fitted to -0.5 to 0.5 m/s and -30 to 20 N: a tenth more is 0.1 m/s and 5 N.
FittedModel GoodModel() {
  FittedModel model;
  model.dof = Dof::kSurge;
  model.force_unit = "N";
  model.train.nmae = 0.3;
  model.range = {.speed = {-0.5, 0.5}, .force = {-30.0, 20.0}};
  return model;
}

LogPrediction PredictionOf(double speed, double force) {
  LogPrediction prediction;
  Segment& segment = prediction.segments.emplace_back();
  segment.time = {0.0, 1.0};
  segment.velocity = {0.0, speed};
  segment.command = {{0.0}, {force}};
  prediction.velocity = {{0.0, speed}};
  prediction.figures = {.mae = 0.01, .nmae = 0.3};
  return prediction;
}

TEST(RemarksOn, AreNoneOfAGoodModelWithinItsRange) {
  EXPECT_THAT(RemarksOn(GoodModel(), PredictionOf(0.59, -34.0)), IsEmpty());
}

TEST(RemarksOn, NameAPoorModelAndAPoorPrediction) {
  FittedModel model = GoodModel();
  model.train.nmae = 0.42;
  LogPrediction prediction = PredictionOf(0.2, 10.0);
  prediction.figures.nmae = 0.836;
  EXPECT_THAT(RemarksOn(model, prediction),
              ElementsAre("The model is a poor fit: its NMAE on the data that it was fitted to is "
                          "0.42, above 0.3.",
                          "The prediction of this log is poor: its NMAE is 0.84, above 0.3."));
}

TEST(RemarksOn, NameSpeedsAndForcesBeyondTheFit) {
  EXPECT_THAT(RemarksOn(GoodModel(), PredictionOf(-0.61, 26.0)),
              ElementsAre("The speed of this log, -0.61 to 0 m/s, leaves what the model was fitted "
                          "to, -0.5 to 0.5 m/s. Beyond it the model extrapolates.",
                          "The force of this log, 26 to 26 N, leaves what the model was fitted to, "
                          "-30 to 20 N. Beyond it the model extrapolates."));
}

TEST(RemarksOn, TakeThePredictedSpeedWhereNoneWasMeasured) {
  LogPrediction prediction = PredictionOf(0.9, 0.0);
  prediction.segments[0].velocity = {0.0, std::nan("")};
  prediction.figures = {};
  EXPECT_EQ(RemarksOn(GoodModel(), prediction).size(), 1u);
}

TEST(RemarksOn, DoNotGuessARangeThatTheFileDoesNotHold) {
  FittedModel model = GoodModel();
  model.range.reset();
  EXPECT_THAT(RemarksOn(model, PredictionOf(9.0, 900.0)), IsEmpty());
}

}  // namespace
}  // namespace fathom
