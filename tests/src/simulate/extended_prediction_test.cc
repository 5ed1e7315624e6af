// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/extended_prediction.h"

#include "fathom/simulate/prediction.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// A body of 2 kg without damping, pushed by 4 N: v = v0 + 2 t.
constexpr UncoupledModel<double> kModel = {2.0, 0.0, 0.0, 0.0};

EffectInputs PushedInputs() {
  EffectInputs inputs;
  inputs.command = {{0.0, 0.9}, {4.0, 4.0}};
  inputs.velocity[Index(Dof::kYaw)] = {{0.0, 10.0}, {0.5, 0.5}};
  return inputs;
}

ExtendedModel With(const char* name, std::vector<double> values) {
  return {kModel, {{FindEffect(name), {.dof = Dof::kSurge, .partner = Dof::kYaw}, values}}};
}

TEST(PredictReadings, WithoutEffectsIsTheBaselinesPrediction) {
  Segment segment;
  segment.time = {1.0, 1.5, 2.0};
  segment.velocity = {0.1, 0.2, 0.3};
  segment.command = PushedInputs().command;
  const auto readings =
      PredictReadings({{3.0, 7.0, 5.0, 1.0}, {}}, PushedInputs(), segment.time, {0.5, 0.0});
  const auto expected = PredictVelocity({3.0, 7.0, 5.0, 1.0}, segment, 0.5);
  ASSERT_TRUE(readings && expected);
  // Two simulations with steps of their own, at most 0.1 s: (0.1 s / 0.2 s)^5 / 120 of 0.3 m/s.
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR((*readings)[i], (*expected)[i], 1e-4);
}

TEST(PredictReadings, ShowWhatTheSensorAddsToTheVelocity) {
  const auto readings =
      PredictReadings(With("sensor_bias", {0.3}), PushedInputs(), {1.0, 1.5}, {0.5, 0.0});
  ASSERT_TRUE(readings);
  EXPECT_NEAR((*readings)[0], 0.8, 1e-12);
  EXPECT_NEAR((*readings)[1], 1.8, 1e-12);
}

TEST(VelocityBehind, UndoesWhatTheSensorDoes) {
  const EffectInputs inputs = PushedInputs();
  EXPECT_NEAR(VelocityBehind(With("sensor_bias", {0.3}), inputs, 1.0, 0.5), 0.2, 1e-12);
  // y = v - l r, r = 0.5 rad/s.
  EXPECT_NEAR(VelocityBehind(With("lever_arm", {0.2}), inputs, 1.0, 0.5), 0.6, 1e-12);
  // y = v / cos a + v_j tan a.
  EXPECT_NEAR(VelocityBehind(With("sensor_misalignment", {0.3}), inputs, 1.0, 0.5),
              (0.5 - 0.5 * std::tan(0.3)) * std::cos(0.3),
              1e-12);
  EXPECT_NEAR(VelocityBehind(With("thruster_lag", {0.4}), inputs, 1.0, 0.5), 0.5, 1e-12);
}

// v = v0 + 2 t, T dy/dt = v - y: y = v - 2 T + (y0 - v0 + 2 T) exp(-t / T).
TEST(StateBehind, ShowsTheFirstReadingsOfALaggingSensorUnderWay) {
  const double T = 0.8, v0 = 0.7, y0 = 0.2;
  const EffectInputs inputs = PushedInputs();
  Segment segment;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.1 * i;
    segment.time.push_back(1.0 + t);
    segment.velocity.push_back(v0 + 2.0 * (t - T) + (y0 - v0 + 2.0 * T) * std::exp(-t / T));
  }
  const ExtendedModel model = With("sensor_lag", {T});
  const auto state =
      StateBehind(model, inputs, 1.0, segment.time, segment.velocity, {5.0, 3.0, -4.0});
  ASSERT_TRUE(state);
  EXPECT_NEAR(state->velocity, v0, 1e-9);
  EXPECT_NEAR(state->reading_excess, y0 - v0, 1e-9);
  EXPECT_EQ(state->position, 3.0);
  // The free run from there shows every reading.
  const std::vector<double> positions = {0.0};
  EXPECT_NEAR(FiguresOf(model, inputs, std::vector{segment}, positions).mae, 0.0, 1e-9);
}

TEST(StateBehind, TakesWhatASingleReadingTells) {
  const auto state =
      StateBehind(With("sensor_lag", {0.8}), PushedInputs(), 1.0, {1.0}, {0.5}, {0.5, 0.0});
  ASSERT_TRUE(state);
  EXPECT_NEAR(state->velocity, 0.5, 1e-12);
  EXPECT_NEAR(state->reading_excess, 0.0, 1e-12);
}

TEST(FiguresOfExtendedModels, CountFromWhereTheReadingStarts) {
  Segment segment;
  segment.time = {1.0, 1.5, 2.0};
  segment.velocity = {0.5, 2.0, 2.0};  // predicted 0.5, 1.5, 2.5
  const std::vector<Segment> segments = {segment};
  const std::vector<double> positions = {0.0};
  const FitFigures figures =
      FiguresOf(With("sensor_bias", {0.3}), PushedInputs(), segments, positions);
  EXPECT_NEAR(figures.mae, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(figures.nmae, 1.0 / 4.5, 1e-12);
  EXPECT_EQ(figures.num_samples, 3);
}

// A spring of 8 N/m on 2 kg, held at 0.5 m from its rest by 4 N: nothing moves; from 0 it does.
TEST(PredictReadings, StartAtThePositionTheyAreGiven) {
  const ExtendedModel spring = With("position_stiffness", {8.0});
  const auto at_rest = PredictReadings(spring, PushedInputs(), {1.0, 2.0}, {0.0, 0.5});
  const auto pulled = PredictReadings(spring, PushedInputs(), {1.0, 2.0}, {0.0, 0.0});
  ASSERT_TRUE(at_rest && pulled);
  EXPECT_NEAR((*at_rest)[1], 0.0, 1e-9);
  // v = x0 w sin(w t), w = 2 rad/s.
  EXPECT_NEAR((*pulled)[1], 0.5 * 2.0 * std::sin(2.0), 1e-4);
}

TEST(PositionAt, LiesBetweenThePosesAndIsZeroWithout) {
  Log log;
  EXPECT_EQ(PositionAt(log, Dof::kHeave, 1.0), 0.0);
  log.pose =
      Stream{{0.0, 1.0, 2.0},
             {"x", "y", "z", "qx", "qy", "qz", "qw"},
             {{0, 0, 0}, {0, 0, 0}, {3.0, 4.0, 6.0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1, 1}}};
  EXPECT_NEAR(PositionAt(log, Dof::kHeave, 1.25), 4.5, 1e-12);
  EXPECT_NEAR(PositionAt(log, Dof::kHeave, -7.0), 3.0, 1e-12);
  EXPECT_NEAR(PositionAt(log, Dof::kHeave, 9.0), 6.0, 1e-12);
}

}  // namespace
}  // namespace fathom
