// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/prediction_check.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// 200 s of two tones at 10 Hz, measured as `factor` times the prediction plus `bias`, with noise.
LogPrediction Measured(double factor, double noise, double bias = 0.0) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  LogPrediction prediction;
  Segment& segment = prediction.segments.emplace_back();
  std::vector<double>& predicted = prediction.velocity.emplace_back();
  prediction.parts = {LogPart::kTrain};
  for (int row = 0; row < 2000; ++row) {
    const double t = 0.1 * row;
    const double speed = 0.3 * std::sin(0.4 * t) + 0.2 * std::sin(0.9 * t + 1.0);
    segment.time.push_back(t);
    predicted.push_back(speed);
    segment.velocity.push_back(factor * speed + bias + noise * normal(random));
  }
  return prediction;
}

TEST(PredictionCheck, PassesASoundPrediction) {
  EXPECT_FALSE(CheckPrediction(Measured(1.0, 0.01), Dof::kSurge));
  EXPECT_FALSE(CheckPrediction(Measured(0.75, 0.01), Dof::kSurge));
  EXPECT_FALSE(CheckPrediction(Measured(1.4, 0.01), Dof::kSurge));
}

// The motion has a standard deviation of 0.25 m/s.
TEST(PredictionCheck, PassesNoiseThatHidesTheMotion) {
  EXPECT_FALSE(CheckPrediction(Measured(1.0, 0.2), Dof::kSurge));
  EXPECT_FALSE(CheckPrediction(Measured(1.0, 0.5), Dof::kSurge));
}

TEST(PredictionCheck, PassesAnotherMean) {
  EXPECT_FALSE(CheckPrediction(Measured(1.0, 0.01, /*bias=*/0.5), Dof::kHeave));
}

TEST(PredictionCheck, WarnsOfAnotherSizeOrSign) {
  for (const double factor : {-1.0, 0.0, 0.5, 1.94, 100.0}) {
    const auto finding = CheckPrediction(Measured(factor, 0.01), Dof::kSurge);
    if (factor == 0.0) {
      EXPECT_FALSE(finding);  // nothing that moves is measured: constant_velocity's
      continue;
    }
    ASSERT_TRUE(finding) << factor;
    EXPECT_EQ(finding->code, "prediction");
    EXPECT_EQ(finding->severity, Severity::kWarning);
  }
  const auto finding = CheckPrediction(Measured(2.0, 0.0), Dof::kSurge);
  ASSERT_TRUE(finding);
  EXPECT_THAT(finding->sentence, HasSubstr("is 2 ± "));
  EXPECT_THAT(finding->sentence, HasSubstr("misses 0.25 times its variance"));
}

TEST(PredictionCheck, WritesAHundredWithoutAnExponent) {
  const auto finding = CheckPrediction(Measured(0.09, 0.0), Dof::kSurge);
  ASSERT_TRUE(finding);
  // ((1 - 0.09) / 0.09)^2 = 102
  EXPECT_THAT(finding->sentence, HasSubstr("misses 100 times its variance"));
}

// A command in kN moves the prediction by next to nothing after its start has died away.
TEST(PredictionCheck, WarnsOfAPredictionThatHardlyMoves) {
  LogPrediction prediction = Measured(1.0, 0.01);
  for (int row = 0; row < 2000; ++row) {
    prediction.velocity[0][row] = 0.2 * std::exp(-0.05 * row) + 1e-3 * prediction.velocity[0][row];
  }
  const auto finding = CheckPrediction(prediction, Dof::kYaw);
  ASSERT_TRUE(finding);
  EXPECT_THAT(finding->sentence, HasSubstr("does not follow the rate of this log"));
}

TEST(PredictionCheck, WarnsOfAPredictionThatDiverges) {
  const auto finding = CheckPrediction(std::nullopt, Dof::kSurge);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->code, "prediction");
}

TEST(PredictionCheck, LeavesOutWhatIsInNoFigure) {
  LogPrediction prediction = Measured(-1.0, 0.01);
  prediction.parts = {LogPart::kOutside};
  EXPECT_FALSE(CheckPrediction(prediction, Dof::kSurge));
}

}  // namespace
}  // namespace fathom
