// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/motion/predicted_motion.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(PredictedMotion, AgreesWithDifferences) {
  HeldCommand command;
  std::vector<double> time;
  for (int i = 0; i < 200; ++i) {
    command.time.push_back(0.1 * i);
    command.value.push_back(30.0 * std::sin(0.05 * i));
    if (i > 3 && i < 180) time.push_back(0.1 * i + 0.037);
  }
  PredictedMotion motion(command, time, 2, {0.7, 0.2, 0.1});
  MotionUnknowns unknowns;
  unknowns.model = {std::log(120.0), 40.0, 15.0, 3.0};
  unknowns.start = {0.1, 0.4};
  for (int i = 0; i < kNumResponse; ++i) unknowns.response[i] = 0.01 * (i + 1);
  unknowns.clock_offset = 0.02;
  ASSERT_TRUE(motion.Update(unknowns));
  constexpr size_t kFrame = 150;
  const PredictedMotion::Derivatives D = motion.MeanDerivatives(kFrame);
  const auto differ = [&](auto move) {
    const double h = 1e-5;
    MotionUnknowns up = unknowns, down = unknowns;
    move(&up, h);
    move(&down, -h);
    EXPECT_TRUE(motion.Update(up));
    const PoseVector above = motion.Mean(kFrame);
    EXPECT_TRUE(motion.Update(down));
    return PoseVector((above - motion.Mean(kFrame)) / (2.0 * h));
  };
  const auto expect_column = [&](int column, const PoseVector& slope, double tolerance = 1e-6) {
    EXPECT_LT((D.col(column) - slope).norm(), tolerance * (1.0 + slope.norm())) << column;
  };
  for (int i = 0; i < kModelColumns; ++i) {
    expect_column(i, differ([&](MotionUnknowns* u, double h) { u->model[i] += h; }));
  }
  for (int i = 0; i < 2; ++i) {
    expect_column(kStartColumns + i,
                  differ([&](MotionUnknowns* u, double h) { u->start[i] += h; }));
  }
  for (int i = 0; i < kNumResponse; ++i) {
    expect_column(kResponseColumns + i,
                  differ([&](MotionUnknowns* u, double h) { u->response[i] += h; }));
  }
  // This one is of the exact solution, not of the numerical one.
  expect_column(
      kClockColumn, differ([&](MotionUnknowns* u, double h) { u->clock_offset += h; }), 1e-4);
}

}  // namespace
}  // namespace fathom
