// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/prediction.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// A body of 2 kg without damping, pushed by 4 N: v = v0 + 2 t.
constexpr UncoupledModel<double> kModel = {2.0, 0.0, 0.0, 0.0};

Segment SegmentWith(std::vector<double> velocity) {
  Segment segment;
  segment.time = {1.0, 1.5, 2.0};
  segment.velocity = std::move(velocity);
  segment.command = {{0.0}, {4.0}};
  return segment;
}

EffectInputs PushedByInputs() {
  EffectInputs inputs;
  inputs.command = {{0.0, 0.9}, {4.0, 4.0}};
  inputs.velocity[Index(Dof::kYaw)] = {{0.0, 10.0}, {0.5, 0.5}};
  return inputs;
}

ExtendedModel ModelWith(const char* name, std::vector<double> values) {
  return {kModel, {{FindEffect(name), {.dof = Dof::kSurge, .partner = Dof::kYaw}, values}}};
}

TEST(Predict, RunsFreeFromTheGivenStart) {
  const auto predicted = Predict({kModel}, SegmentWith({0.1, -7.0, 9.0}), {0.5});
  ASSERT_TRUE(predicted);
  EXPECT_DOUBLE_EQ((*predicted)[0], 0.5);
  EXPECT_DOUBLE_EQ((*predicted)[1], 1.5);
  EXPECT_DOUBLE_EQ((*predicted)[2], 2.5);
}

// An effect at its null: two simulations with steps of their own, at most 0.1 s.
TEST(Predict, TakesTheSameWayWithAnEffectThatDoesNothing) {
  const EffectInputs inputs = PushedByInputs();
  const UncoupledModel<double> damped = {3.0, 7.0, 5.0, 1.0};
  Segment segment = SegmentWith({0.1, 0.2, 0.3});
  segment.command = inputs.command;
  ExtendedModel nested = ModelWith("sensor_bias", {0.0});
  nested.baseline = damped;
  const auto plain = Predict({damped}, segment, {0.5});
  const auto extended = Predict(nested, segment, {0.5}, &inputs);
  ASSERT_TRUE(plain && extended);
  // (0.1 s / 0.2 s)^5 / 120 of 0.3 m/s.
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR((*plain)[i], (*extended)[i], 1e-4);
}

TEST(Predict, ShowsWhatTheSensorAddsToTheVelocity) {
  const EffectInputs inputs = PushedByInputs();
  const auto readings =
      Predict(ModelWith("sensor_bias", {0.3}), SegmentWith({0.0, 0.0, 0.0}), {0.5}, &inputs);
  ASSERT_TRUE(readings);
  EXPECT_NEAR((*readings)[0], 0.8, 1e-12);
  EXPECT_NEAR((*readings)[1], 1.8, 1e-12);
}

// A spring of 8 N/m on 2 kg, held at 0.5 m from its rest by 4 N: nothing moves; from 0 it does.
TEST(Predict, StartsAtThePositionItIsGiven) {
  const ExtendedModel spring = ModelWith("position_stiffness", {8.0});
  const EffectInputs inputs = PushedByInputs();
  const Segment segment = SegmentWith({0.0, 0.0, 0.0});
  const auto at_rest = Predict(spring, segment, {0.0, 0.5}, &inputs);
  const auto pulled = Predict(spring, segment, {0.0, 0.0}, &inputs);
  ASSERT_TRUE(at_rest && pulled);
  EXPECT_NEAR((*at_rest)[2], 0.0, 1e-9);
  // v = x0 w sin(w t), w = 2 rad/s.
  EXPECT_NEAR((*pulled)[2], 0.5 * 2.0 * std::sin(2.0), 1e-4);
}

TEST(FigureSums, FollowEquations10And11OfThePaperOverAllRuns) {
  // Errors 0, 0.5, 0.5 and 0, 0.2, 0.
  FigureSums sums;
  const std::vector<double> time = {1.0, 1.5, 2.0};
  sums.Add(time, std::vector{0.5, 2.0, 2.0}, std::vector{0.5, 1.5, 2.5});
  sums.Add(time, std::vector{-1.0, 0.2, 1.0}, std::vector{-1.0, 0.0, 1.0});
  const FitFigures figures = sums.Figures();
  EXPECT_NEAR(figures.mae, 1.2 / 6.0, 1e-14);
  EXPECT_NEAR(figures.nmae, 1.2 / (0.5 + 2.0 + 2.0 + 1.0 + 0.2 + 1.0), 1e-14);
  EXPECT_EQ(figures.num_samples, 6);
  EXPECT_DOUBLE_EQ(figures.duration, 2.0);
  EXPECT_TRUE(std::isnan(FigureSums().Figures().nmae));
}

}  // namespace
}  // namespace fathom
