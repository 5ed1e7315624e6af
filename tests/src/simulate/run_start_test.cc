// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/run_start.h"

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

TEST(InitialVelocity, IsSmoothedWhereTheSegmentKnowsHow) {
  Segment segment;
  segment.velocity = {0.5, 2.0, 2.0};
  EXPECT_EQ(InitialVelocity(segment), 0.5);
  segment.initial_velocity = 0.4;
  EXPECT_EQ(InitialVelocity(segment), 0.4);
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
  EXPECT_NEAR(FiguresOf(model, std::vector{segment}, positions, &inputs).mae, 0.0, 1e-9);
}

TEST(StateBehind, TakesWhatASingleReadingTells) {
  const auto state =
      StateBehind(With("sensor_lag", {0.8}), PushedInputs(), 1.0, {1.0}, {0.5}, {0.5, 0.0});
  ASSERT_TRUE(state);
  EXPECT_NEAR(state->velocity, 0.5, 1e-12);
  EXPECT_NEAR(state->reading_excess, 0.0, 1e-12);
}

TEST(StartOf, IsTheReadingItselfWithoutEffects) {
  Segment segment;
  segment.time = {1.0, 1.5};
  segment.velocity = {0.1, 0.2};
  const auto start = StartOf({kModel}, segment, 0.5, 3.0);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->velocity, 0.5);
  EXPECT_EQ(start->position, 3.0);
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
