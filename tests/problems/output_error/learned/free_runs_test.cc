// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/free_runs.h"

#include <cmath>
#include <random>
#include <vector>

#include "synthetic_run.h"
#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace fathom {
namespace {

std::vector<BinnedSegment> BinsOfAll(const Segment& segment, FittedOutput output) {
  return {BinnedSegmentOf(segment, output, 0.01, std::vector<bool>(segment.time.size(), false))};
}

// With runs of 50 s from their own best state, no state of the whole run matters: shifting the
// position, or the speed, of a later part leaves nothing.
TEST(FreeRunsOf, StartEachRunFromTheStateThatFitsBest) {
  SyntheticRun run = {.command = Multisine};
  run.duration = 100.0;
  Segment segment = Synthesize(run, 1);
  // The samples of the second run.
  for (size_t i = 500; i < segment.time.size(); ++i) segment.position[i] += 7.0;
  const auto runs = FreeRunsOf(std::vector{run.truth}, BinsOfAll(segment, FittedOutput::kPosition));
  ASSERT_TRUE(runs.has_value());
  EXPECT_LT(runs->sum_of_squares, 1e-9);
}

// White noise on the sensor: a run of n samples with one free state misses (n - 1) sigma^2, with a
// standard deviation of sqrt(2 n) sigma^2.
TEST(FreeRunsOf, MissTheSensorsNoiseLessTheStatesShare) {
  SyntheticRun run = {.command = Multisine};
  run.duration = 240.0;
  run.noise = 0.01;
  const Segment segment = Synthesize(run, 2);
  const auto runs = FreeRunsOf(std::vector{run.truth}, BinsOfAll(segment, FittedOutput::kVelocity));
  ASSERT_TRUE(runs.has_value());
  const double n = static_cast<double>(segment.time.size());
  EXPECT_NEAR(runs->sum_of_squares / 1e-4, n - 4.0, 3.0 * std::sqrt(2.0 * n));
}

// Efron's penalty against the definition: of a linear estimator, the mean loss on fresh data.
TEST(FreeRuns, ExpectOfLeftOutDataWhatFreshDataShow) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  constexpr int kNumRows = 30;
  Eigen::MatrixXd J(kNumRows, kNumParameters);
  for (double& entry : J.reshaped()) entry = normal(generator);
  FreeRuns runs;
  runs.gram = J.transpose() * J;
  const ParameterCovariance C = runs.gram.inverse();  // under white noise of variance 1
  const auto solver = J.householderQr();
  double expected = 0.0, fresh = 0.0;
  constexpr int kNumDraws = 20000;
  for (int k = 0; k < kNumDraws; ++k) {
    Eigen::VectorXd seen(kNumRows), unseen(kNumRows);
    for (double& e : seen) e = normal(generator);
    for (double& e : unseen) e = normal(generator);
    const Eigen::VectorXd fitted = J * solver.solve(seen);
    runs.sum_of_squares = (seen - fitted).squaredNorm();
    expected += runs.ExpectedOfLeftOutData(C) / kNumDraws;
    fresh += (unseen - fitted).squaredNorm() / kNumDraws;
  }
  // Both are n + p; the mean of either has a standard deviation of sqrt(2 (n + p) / draws) = 0.06.
  EXPECT_NEAR(expected, kNumRows + kNumParameters, 0.2);
  EXPECT_NEAR(fresh, kNumRows + kNumParameters, 0.2);
}

}  // namespace
}  // namespace fathom
