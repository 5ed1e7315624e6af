// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/prediction.h"

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

TEST(PredictVelocity, RunsFreeFromTheGivenStart) {
  const auto predicted = PredictVelocity(kModel, SegmentWith({0.1, -7.0, 9.0}), 0.5);
  ASSERT_TRUE(predicted);
  EXPECT_DOUBLE_EQ((*predicted)[0], 0.5);
  EXPECT_DOUBLE_EQ((*predicted)[1], 1.5);
  EXPECT_DOUBLE_EQ((*predicted)[2], 2.5);
}

TEST(InitialVelocity, IsSmoothedWhereTheSegmentKnowsHow) {
  Segment segment = SegmentWith({0.5, 2.0, 2.0});
  EXPECT_EQ(InitialVelocity(segment), 0.5);
  segment.initial_velocity = 0.4;
  EXPECT_EQ(InitialVelocity(segment), 0.4);
}

TEST(FiguresOf, FollowEquations10And11OfThePaperOverAllSegments) {
  // Predicted 0.5, 1.5, 2.5 and -1, 0, 1: errors 0, 0.5, 0.5 and 0, 0.2, 0.
  const std::vector<Segment> segments = {SegmentWith({0.5, 2.0, 2.0}),
                                         SegmentWith({-1.0, 0.2, 1.0})};
  const FitFigures figures = FiguresOf(kModel, segments);
  EXPECT_NEAR(figures.mae, 1.2 / 6.0, 1e-14);
  EXPECT_NEAR(figures.nmae, 1.2 / (0.5 + 2.0 + 2.0 + 1.0 + 0.2 + 1.0), 1e-14);
  EXPECT_EQ(figures.num_samples, 6);
  EXPECT_DOUBLE_EQ(figures.duration, 2.0);
}

TEST(FiguresOf, AreNotANumberWhenTheRunDivergesOrThereIsNoData) {
  const std::vector<Segment> segments = {SegmentWith({1.0, 2.0, 2.0})};
  EXPECT_TRUE(std::isnan(FiguresOf({1.0, 0.0, -90.0, 0.0}, segments).nmae));
  EXPECT_TRUE(std::isnan(FiguresOf(kModel, {}).nmae));
  const std::vector<Segment> at_rest = {SegmentWith({0.0, 0.0, 0.0})};
  EXPECT_TRUE(std::isnan(FiguresOf(kModel, at_rest).nmae));
  EXPECT_NEAR(FiguresOf(kModel, at_rest).mae, 1.0, 1e-14);
}

}  // namespace
}  // namespace fathom
