// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/free_run.h"

#include "fathom/simulate/fitted_start.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// A body of 2 kg without damping, pushed by 4 N: v = v0 + 2 t, x = x0 + v0 t + t^2.
constexpr UncoupledModel<double> kPushed = {2.0, 0.0, 0.0, 0.0};

EffectInputs PushedInputs() {
  EffectInputs inputs;
  inputs.command = {{0.0, 0.9}, {4.0, 4.0}};
  inputs.velocity[Index(Dof::kYaw)] = {{0.0, 10.0}, {0.5, 0.5}};
  return inputs;
}

ExtendedModel With(const char* name, std::vector<double> values) {
  return {kPushed, {{FindEffect(name), {.dof = Dof::kSurge, .partner = Dof::kYaw}, values}}};
}

// Six seconds from t = 1 s, with errors of alternating sign, which no line through them sees.
Segment Measured(double v0, double error) {
  Segment segment;
  segment.command = PushedInputs().command;
  for (int i = 0; i < 60; ++i) {
    segment.time.push_back(1.0 + 0.1 * i);
    segment.velocity.push_back(v0 + 0.2 * i + (i % 2 == 0 ? error : -error));
  }
  return segment;
}

TEST(FittedStart, IsWhereTheRunFitsTheFirstSecondsNotTheFirstSample) {
  const Segment segment = Measured(0.7, 0.1);
  EXPECT_DOUBLE_EQ(segment.velocity.front(), 0.8);
  const auto start = FittedStart({kPushed}, PushedInputs(), MotionOf(segment));
  ASSERT_TRUE(start);
  // 21 samples, of which the sum of errors is 0.1.
  EXPECT_NEAR(start->velocity, 0.7 + 0.1 / 21.0, 1e-9);
  EXPECT_EQ(start->position, 0.0);
}

TEST(FittedStart, PassesOverAWildSample) {
  Segment segment = Measured(0.7, 0.01);
  segment.velocity.front() = -30.0;
  const auto start = FittedStart({kPushed}, PushedInputs(), MotionOf(segment));
  ASSERT_TRUE(start);
  EXPECT_NEAR(start->velocity, 0.7, 0.002);
}

TEST(FittedStart, TakesSpeedAndPlaceFromPositions) {
  Segment segment = Measured(5.0, 0.0);  // velocities that are not the derivative
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    const double t = segment.time[i] - 1.0;
    segment.position.push_back(3.0 + 0.7 * t + t * t);
  }
  const auto start = FittedStart({kPushed}, PushedInputs(), MotionOf(segment));
  ASSERT_TRUE(start);
  EXPECT_NEAR(start->velocity, 0.7, 1e-9);
  EXPECT_NEAR(start->position, 3.0, 1e-9);
}

TEST(FittedStart, UndoesWhatTheSensorDoes) {
  const EffectInputs inputs = PushedInputs();
  const auto speed = [&](const ExtendedModel& model) {
    const auto start = FittedStart(model, inputs, MotionOf(Measured(0.5, 0.0)));
    return start ? start->velocity : std::nan("");
  };
  EXPECT_NEAR(speed(With("sensor_bias", {0.3})), 0.2, 1e-9);
  // y = v - l r, r = 0.5 rad/s.
  EXPECT_NEAR(speed(With("lever_arm", {0.2})), 0.6, 1e-9);
}

// v = v0 + 2 t, T dy/dt = v - y: y = v - 2 T + (y0 - v0 + 2 T) exp(-t / T).
TEST(FittedStart, FindsWhatALaggingSensorShowedBefore) {
  const double T = 0.8, v0 = 0.7, y0 = 0.2;
  Segment segment = Measured(v0, 0.0);
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    const double t = segment.time[i] - 1.0;
    segment.velocity[i] = v0 + 2.0 * (t - T) + (y0 - v0 + 2.0 * T) * std::exp(-t / T);
  }
  const EffectInputs inputs = PushedInputs();
  const ExtendedModel model = With("sensor_lag", {T});
  const auto start = FittedStart(model, inputs, MotionOf(segment), 3.0);
  ASSERT_TRUE(start);
  EXPECT_NEAR(start->velocity, v0, 1e-6);
  EXPECT_NEAR(start->reading_excess, y0 - v0, 1e-6);
  EXPECT_EQ(start->position, 3.0);
  const auto run = FreeRunOver(segment, model, 0.0, &inputs);
  ASSERT_TRUE(run);
  for (std::size_t i = 0; i < run->time.size(); ++i) {
    EXPECT_NEAR(run->predicted[i], run->measured[i], 1e-6);
  }
}

TEST(FreeRunOver, TakesNothingOfTheMeasurementButItsStart) {
  Segment segment = Measured(0.7, 0.0);
  for (std::size_t i = 30; i < segment.velocity.size(); ++i) segment.velocity[i] = -9.0;
  const auto run = FreeRunOver(segment, {kPushed});
  ASSERT_TRUE(run);
  EXPECT_NEAR(run->predicted.back(), 0.7 + 2.0 * 5.9, 1e-9);
  EXPECT_EQ(run->measured, segment.velocity);
}

TEST(FiguresOf, AreThoseOfTheRunsAndNotANumberWhereOneDiverges) {
  const std::vector<Segment> segments = {Measured(0.7, 0.1), Measured(-1.0, 0.1)};
  const FitFigures figures = FiguresOf({kPushed}, segments);
  EXPECT_NEAR(figures.mae, 0.1, 0.001);
  EXPECT_EQ(figures.num_samples, 120);
  EXPECT_NEAR(figures.duration, 11.8, 1e-9);
  EXPECT_TRUE(std::isnan(FiguresOf({{1.0, 0.0, -900.0, 0.0}}, segments).nmae));
  EXPECT_TRUE(std::isnan(FiguresOf({kPushed}, {}).nmae));
}

}  // namespace
}  // namespace fathom
