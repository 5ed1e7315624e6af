// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/whitened_cost.h"

#include "fathom/output_error/learned/binned_run.h"

#include <array>
#include <cmath>
#include <vector>

#include "synthetic_run.h"
#include <Eigen/Core>
#include <ceres/cost_function.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

const std::array<double, 4> kParameters = {std::log(700.0), 45.0, 55.0, 3.0};
const std::array<double, 2> kState = {0.13, -0.4};

Segment NoisySegment() {
  SyntheticRun run = {.command = Multisine};
  run.noise = 0.02;
  run.duration = 40.0;
  return Synthesize(run, 3);
}

BinnedSegment BinsWithGaps(const Segment& segment, FittedOutput output) {
  std::vector<bool> is_wild(segment.time.size(), false);
  for (const int i : {0, 57, 58, 59, 200}) is_wild[i] = true;
  return BinnedSegmentOf(segment, output, 0.3, is_wild);
}

// Turbulence and a sensor with a memory; every part of the noise is there.
NoiseModel FullNoise() {
  NoiseModel noise;
  noise.velocity = {0.011, {0.007, 1.3}};
  noise.displacement = {0.012, {0.009, 2.1}};
  noise.disturbance = {0.008, 3.7};
  noise.damping_rate = 0.17;
  return noise;
}

Eigen::VectorXd ResidualsAt(const ceres::CostFunction& cost,
                            const std::array<double, 4>& parameters,
                            const std::array<double, 2>& state) {
  Eigen::VectorXd residuals(cost.num_residuals());
  const std::array<const double*, 3> blocks = {
      parameters.data(), &parameters[kBuoyancy], state.data()};
  EXPECT_TRUE(cost.Evaluate(blocks.data(), residuals.data(), nullptr));
  return residuals;
}

// Central differences are good to about the square of the step, relative: 1e-8 of each column.
void ExpectJacobiansToBeDifferences(FittedOutput output) {
  const Segment segment = NoisySegment();
  const BinnedSegment bins = BinsWithGaps(segment, output);
  const Whitener whitener(FullNoise(), bins.samples);
  const auto cost = MakeWhitenedCost(bins, whitener);
  const int n = cost->num_residuals();
  const int state_size = StateSize(output);
  RowMajorMatrix by_vehicle(n, kBuoyancy), by_buoyancy(n, 1), by_state(n, state_size);
  Eigen::VectorXd residuals(n);
  const std::array<const double*, 3> blocks = {
      kParameters.data(), &kParameters[kBuoyancy], kState.data()};
  std::array<double*, 3> jacobians = {by_vehicle.data(), by_buoyancy.data(), by_state.data()};
  ASSERT_TRUE(cost->Evaluate(blocks.data(), residuals.data(), jacobians.data()));
  const auto expect_column = [&](const Eigen::VectorXd& column, auto shifted, double step) {
    const Eigen::VectorXd difference = (shifted(step) - shifted(-step)) / (2.0 * step);
    EXPECT_LT((column - difference).norm(), 1e-6 * column.norm());
    EXPECT_GT(column.norm(), 0.0);
  };
  for (int j = 0; j < 4; ++j) {
    expect_column(
        j < kBuoyancy ? by_vehicle.col(j) : by_buoyancy.col(0),
        [&](double by) {
          auto parameters = kParameters;
          parameters[j] += by;
          return ResidualsAt(*cost, parameters, kState);
        },
        1e-4 * std::max(1.0, std::abs(kParameters[j])));
  }
  for (int j = 0; j < state_size; ++j) {
    expect_column(
        by_state.col(j),
        [&](double by) {
          auto state = kState;
          state[j] += by;
          return ResidualsAt(*cost, kParameters, state);
        },
        1e-4);
  }
}

TEST(WhitenedCost, HasTheJacobiansOfItsResidualsForVelocities) {
  ExpectJacobiansToBeDifferences(FittedOutput::kVelocity);
}

TEST(WhitenedCost, HasTheJacobiansOfItsResidualsForPositions) {
  ExpectJacobiansToBeDifferences(FittedOutput::kPosition);
}

// Under white noise alone a residual is the bin's mean miss over the standard deviation of a mean
// of so many; the misses are those of a simulation of its own.
TEST(WhitenedCost, IsTheMeanMissInStandardDeviations) {
  const Segment segment = NoisySegment();
  const BinnedSegment bins = BinsWithGaps(segment, FittedOutput::kVelocity);
  NoiseModel white;
  white.velocity.white_std = 0.02;  // of a mean of three
  const Whitener whitener(white, bins.samples);
  const auto cost = MakeWhitenedCost(bins, whitener);
  const Eigen::VectorXd residuals = ResidualsAt(*cost, kParameters, kState);
  std::vector<double> v(segment.time.size());
  ASSERT_TRUE(Simulation(segment.command, segment.time)
                  .Run({700.0, 45.0, 55.0, 3.0}, {kState[0], 0.0}, v, {}));
  std::vector<double> sum(bins.size(), 0.0);
  for (size_t i = 0; i < v.size(); ++i) {
    if (bins.bin_of[i] >= 0) sum[bins.bin_of[i]] += v[i] - segment.velocity[i];
  }
  for (int k = 0; k < bins.size(); ++k) {
    const double std = 0.02 * std::sqrt(3.0 / bins.count[k]);
    EXPECT_NEAR(residuals[k], sum[k] / bins.count[k] / std, 1e-9) << k;
  }
}

}  // namespace
}  // namespace fathom
