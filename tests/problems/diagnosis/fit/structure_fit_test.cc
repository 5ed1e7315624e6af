// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/structure_fit.h"

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/start_price.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dense_noise.h"
#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// 60 s at 5 Hz: a sample per bin.
SurgeRun Short() {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.duration = 60.0;
  run.rate = 5.0;
  run.noise_correlation = 0.8;
  return run;
}

TrainingData DataOf(const SurgeRun& run, std::uint64_t seed) {
  const std::vector<Log> logs = {LogOf(run, seed)};
  return TrainingData(MeasuredSegmentsOf(logs, Dof::kSurge).all);
}

std::vector<InitialState> StatesOf(const TrainingData& data) {
  std::vector<InitialState> states;
  for (const MeasuredSegment& segment : data.segments()) states.push_back(segment.initial);
  return states;
}

NoiseModel Coloured() {
  NoiseModel noise;
  noise.velocity = {.white_std = 0.004, .coloured = {.std = 0.009, .time = 0.9}};
  return noise;
}

// The five unknowns of a baseline fit of one segment without poses.
Eigen::VectorXd Unknowns(const StructureFit& fit) {
  Eigen::VectorXd p(5);
  p << fit.model.baseline.inertia, fit.model.baseline.quadratic_damping,
      fit.model.baseline.linear_damping, fit.model.baseline.buoyancy, fit.initial[0].velocity;
  return p;
}

Eigen::VectorXd SimulateAt(const TrainingData& data,
                           const StructureFit& fit,
                           const Eigen::VectorXd& p) {
  ExtendedModel model = fit.model;
  model.baseline = {p[0], p[1], p[2], p[3]};
  std::vector<InitialState> initial = fit.initial;
  initial[0].velocity = p[4];
  return *data.Simulate(model, initial);
}

// By central differences of the simulation.
Eigen::MatrixXd JacobianAt(const TrainingData& data, const StructureFit& fit) {
  const Eigen::VectorXd p = Unknowns(fit);
  Eigen::MatrixXd J(data.bins().size(), p.size());
  for (Eigen::Index k = 0; k < p.size(); ++k) {
    Eigen::VectorXd low = p, high = p;
    const double step = 1e-4 * std::max(std::abs(p[k]), 0.1);
    low[k] -= step;
    high[k] += step;
    J.col(k) = (SimulateAt(data, fit, high) - SimulateAt(data, fit, low)) / (2.0 * step);
  }
  return J;
}

// Against generalised least squares written out: no whitening by a filter, no derivatives by Jets.
TEST(FitStructure, StandsWhereDenseGeneralisedLeastSquaresHasNothingToGain) {
  const TrainingData data = DataOf(Short(), 1);
  const Eigen::MatrixXd S = DenseCovariance(Coloured(), data.samples());
  const Whitener whitener(Coloured(), data.samples());
  const StructureFit fit =
      FitStructure(data, {{700.0, 90.0, 25.0, 1.0}, {}}, StatesOf(data), whitener);
  ASSERT_TRUE(fit.converged);
  const Eigen::VectorXd residual = data.measured() - SimulateAt(data, fit, Unknowns(fit));
  EXPECT_LT((residual - fit.residual).norm(), 1e-9);
  const DenseFit dense = FitDense(S, JacobianAt(data, fit), residual);
  // It ends when a step promises less than 0.01 of chi squared: then none of the unknowns is
  // further than 0.1 standard deviations from where the dense step would take it.
  const double chi_squared = residual.dot(Eigen::LLT<Eigen::MatrixXd>(S).solve(residual));
  EXPECT_NEAR(fit.chi_squared, chi_squared, 1e-6 * chi_squared);
  EXPECT_LT(chi_squared - dense.chi_squared, 0.01);
  const Eigen::MatrixXd covariance = InverseOfSymmetric(dense.information);
  for (int k = 0; k < kNumParameters; ++k) {
    EXPECT_LT(std::abs(dense.solution[k]), 0.1 * std::sqrt(covariance(k, k))) << k;
    for (int j = 0; j < kNumParameters; ++j) {
      const double scale = std::sqrt(covariance(k, k) * covariance(j, j));
      // Central differences are good to 1e-4 or so, and the inverse magnifies that by its
      // condition, below 100 in these units.
      EXPECT_NEAR(fit.covariance(k, j) / scale, covariance(k, j) / scale, 0.01) << k << j;
    }
  }
  const double log_determinant =
      2.0 *
      Eigen::MatrixXd(Eigen::LLT<Eigen::MatrixXd>(S).matrixL()).diagonal().array().log().sum();
  const double n = data.bins().size();
  EXPECT_NEAR(fit.log_likelihood,
              -0.5 * (chi_squared + log_determinant + n * std::log(2.0 * std::numbers::pi)),
              1e-6 * n);
}

// A sensor that lags by 1.2 s, seen from the run's start or amid it, and again after a silence.
TrainingData LaggingData(double first, std::uint64_t seed) {
  SurgeRun run = Short();
  run.duration = 200.0;
  run.noise_correlation = 0.0;
  run.velocity_noise = 0.005;
  run.effects = "sensor_lag:time_constant=1.2";
  const Log log = WithoutMotion(WithoutMotion(LogOf(run, seed), 0.0, first), 80.0, 130.0);
  return TrainingData(MeasuredSegmentsOf(std::vector<Log>{log}, Dof::kSurge).all);
}

StructureFit FitLag(const TrainingData& data) {
  NoiseModel noise;
  noise.velocity.white_std = 0.005;
  const ExtendedModel start = {{700.0, 90.0, 25.0, 1.0}, {{FindEffect("sensor_lag"), {}, {0.4}}}};
  return FitStructure(data, start, StatesOf(data), Whitener(noise, data.samples()));
}

TEST(FitStructure, FreesWhereALaggingSensorStartsInEverySegment) {
  const TrainingData data = LaggingData(30.0, 3);
  ASSERT_EQ(data.segments().size(), 2u);
  const StructureFit fit = FitLag(data);
  ASSERT_TRUE(fit.converged);
  const double std = std::sqrt(fit.covariance(kNumParameters, kNumParameters));
  EXPECT_LT(std, 0.05);
  EXPECT_NEAR(fit.model.effects[0].values[0], 1.2, 4.0 * std);
  const double num_free = static_cast<double>(fit.residual.size() - fit.jacobian.cols());
  EXPECT_NEAR(fit.chi_squared, num_free, 4.0 * std::sqrt(2.0 * num_free));
  // The last columns are the segments' states, velocity and excess in turns.
  ASSERT_EQ(fit.jacobian.cols(), kNumParameters + 1 + 4);
  for (int column = 0; column < 4; ++column) {
    std::vector<InitialState> low = fit.initial, high = fit.initial;
    const auto place = [&](std::vector<InitialState>* initial) -> double& {
      InitialState& state = (*initial)[column / 2];
      return column % 2 == 0 ? state.velocity : state.reading_excess;
    };
    place(&low) -= 1e-4;
    place(&high) += 1e-4;
    const Eigen::VectorXd difference =
        (*data.Simulate(fit.model, high) - *data.Simulate(fit.model, low)) / 2e-4;
    EXPECT_GT(difference.norm(), 0.5);
    EXPECT_LT((difference - fit.jacobian.col(kNumParameters + 1 + column)).norm(), 1e-5) << column;
  }
}

// Both segments begin amid an acceleration, so that y = v is far off there, and what freedom gains
// is what it gains over the fit without it.
TEST(FitStructure, PaysForAFreeStartWhereItIsNeeded) {
  const double log_n = std::log(static_cast<double>(LaggingData(30.0, 3).bins().size()));
  const StructureFit needed = FitLag(LaggingData(30.0, 3));
  ASSERT_EQ(needed.start_gains.size(), 2u);
  EXPECT_GT(std::min(needed.start_gains[0], needed.start_gains[1]), log_n);
  EXPECT_NEAR(PriceOfStarts(LaggingData(30.0, 3), needed.start_gains), 2.0 * log_n, 1e-9);
}

// From rest it starts at what it reads: the excess is noise, chi squared of one degree of freedom.
TEST(FitStructure, PaysNextToNothingWhereTheSensorStartsAtRest) {
  double sum = 0.0;
  const int num_runs = 12;
  for (int seed = 0; seed < num_runs; ++seed) {
    const TrainingData data = LaggingData(0.0, 10 + seed);
    const StructureFit fit = FitLag(data);
    ASSERT_EQ(fit.start_gains.size(), 2u);
    const double log_n = std::log(static_cast<double>(data.bins().size()));
    sum += fit.start_gains[0];
    EXPECT_NEAR(PriceOfStarts(data, fit.start_gains),
                std::min(fit.start_gains[0], log_n) + std::min(fit.start_gains[1], log_n),
                1e-9);
    // Nothing but a sensor's memory has a start to pay for.
    StructureFit quick =
        FitStructure(data, {kSurgeTruth, {}}, StatesOf(data), Whitener(Coloured(), data.samples()));
    EXPECT_TRUE(quick.start_gains.empty());
    EXPECT_EQ(PriceOfStarts(data, quick.start_gains), 0.0);
    EXPECT_EQ(quick.initial[0].reading_excess, 0.0);
  }
  // Mean 1, variance 2: four standard deviations of the sum.
  EXPECT_NEAR(sum, num_runs, 4.0 * std::sqrt(2.0 * num_runs));
}

// The water too: its memory of the time before each segment, beside a sensor's.
TEST(FitStructure, FreesWhatTheWaterRemembersInEverySegment) {
  SurgeRun run = Short();
  run.duration = 200.0;
  run.noise_correlation = 0.0;
  run.velocity_noise = 0.005;
  run.effects = "fluid_memory:coefficient=130:time_constant=4,sensor_lag:time_constant=1.2";
  const Log log = WithoutMotion(WithoutMotion(LogOf(run, 3), 0.0, 30.0), 80.0, 130.0);
  const TrainingData data(MeasuredSegmentsOf(std::vector<Log>{log}, Dof::kSurge).all);
  ASSERT_EQ(data.segments().size(), 2u);
  NoiseModel noise;
  noise.velocity.white_std = 0.005;
  const ExtendedModel start = {
      {700.0, 90.0, 25.0, 1.0},
      {{FindEffect("fluid_memory"), {}, {60.0, 2.0}}, {FindEffect("sensor_lag"), {}, {0.4}}}};
  const StructureFit fit =
      FitStructure(data, start, StatesOf(data), Whitener(noise, data.samples()));
  ASSERT_TRUE(fit.converged);
  const double num_free = static_cast<double>(fit.residual.size() - fit.jacobian.cols());
  EXPECT_NEAR(fit.chi_squared, num_free, 4.0 * std::sqrt(2.0 * num_free));
  // The last columns are the segments' states: velocity, the reading's excess, the water's.
  const int first = kNumParameters + 3;
  ASSERT_EQ(fit.jacobian.cols(), first + 6);
  ASSERT_EQ(fit.start_gains.size(), 4u);
  for (int column = 0; column < 6; ++column) {
    std::vector<InitialState> low = fit.initial, high = fit.initial;
    constexpr double InitialState::*kPlaces[] = {
        &InitialState::velocity, &InitialState::reading_excess, &InitialState::memory_excess};
    low[column / 3].*kPlaces[column % 3] -= 1e-4;
    high[column / 3].*kPlaces[column % 3] += 1e-4;
    const Eigen::VectorXd difference =
        (*data.Simulate(fit.model, high) - *data.Simulate(fit.model, low)) / 2e-4;
    EXPECT_GT(difference.norm(), 0.5);
    EXPECT_LT((difference - fit.jacobian.col(first + column)).norm(), 1e-5) << column;
  }
}

TEST(FitStructure, EndsAtTheSamePlaceFromFarAway) {
  const TrainingData data = DataOf(Short(), 2);
  const Whitener whitener(Coloured(), data.samples());
  const auto near = FitStructure(data, {kSurgeTruth, {}}, StatesOf(data), whitener);
  const auto far = FitStructure(data, {{2500.0, 5.0, 150.0, 10.0}, {}}, StatesOf(data), whitener);
  ASSERT_TRUE(near.converged && far.converged);
  // Both within 0.01 of chi squared of the optimum, so 0.2 standard deviations apart at most.
  for (int k = 0; k < kNumParameters; ++k) {
    EXPECT_NEAR(Unknowns(near)[k], Unknowns(far)[k], 0.2 * std::sqrt(near.covariance(k, k))) << k;
  }
}

// A late thruster wants linear damping below zero (METHODS.md). It is held at zero, presses on it,
// and the others stand where least squares without it has nothing to gain.
TEST(FitStructure, HoldsAParameterAtItsBoundAndTheOthersAtTheirOptimum) {
  SurgeRun run = Short();
  run.model.linear_damping = 1.0;
  run.effects = "thruster_lag:time_constant=1.0";
  const TrainingData data = DataOf(run, 3);
  const Whitener whitener(Coloured(), data.samples());
  const StructureFit fit = FitStructure(data, {kSurgeTruth, {}}, StatesOf(data), whitener);
  ASSERT_TRUE(fit.converged);
  EXPECT_EQ(fit.model.baseline.linear_damping, 0.0);
  EXPECT_TRUE(fit.is_on_bound[kLinearDamping]);
  const Eigen::MatrixXd S = DenseCovariance(Coloured(), data.samples());
  const Eigen::MatrixXd J = JacobianAt(data, fit);
  // Its spread is that without the bound; the others' is that beside a damping known to be zero.
  const Eigen::MatrixXd unbounded = InverseOfSymmetric(FitDense(S, J, fit.residual).information);
  EXPECT_NEAR(
      fit.covariance(kLinearDamping, kLinearDamping) / unbounded(kLinearDamping, kLinearDamping),
      1.0,
      0.01);
  EXPECT_EQ(fit.covariance(kInertia, kLinearDamping), 0.0);
  const Eigen::VectorXd weighted = Eigen::LLT<Eigen::MatrixXd>(S).solve(fit.residual);
  EXPECT_LT(J.col(kLinearDamping).dot(weighted), 0.0);  // downhill is below zero
  Eigen::MatrixXd others(J.rows(), 4);
  others << J.leftCols(2), J.rightCols(2);
  const DenseFit dense = FitDense(S, others, fit.residual);
  EXPECT_LT(fit.residual.dot(weighted) - dense.chi_squared, 0.01);
  EXPECT_NEAR(
      fit.covariance(kInertia, kInertia) / InverseOfSymmetric(dense.information)(0, 0), 1.0, 0.01);
}

// A late thruster wants less damping of what is fast, a memory gives more: there is none, and of
// none the time constant leaves no trace.
TEST(FitStructure, GivesNoSpreadToAParameterOnItsBoundThatTheDataSayNothingOf) {
  SurgeRun run = Short();
  run.effects = "thruster_lag:time_constant=1.0";
  const TrainingData data = DataOf(run, 6);
  const Whitener whitener(Coloured(), data.samples());
  const Effect* memory = FindEffect("fluid_memory");
  const double shortest = memory->info().parameters[1].lower;
  const ExtendedModel start = {kSurgeTruth, {{memory, {}, {0.0, shortest}}}};
  const StructureFit fit = FitStructure(data, start, StatesOf(data), whitener);
  ASSERT_TRUE(fit.converged);
  ASSERT_TRUE(fit.is_on_bound[kNumParameters] && fit.is_on_bound[kNumParameters + 1]);
  EXPECT_GT(fit.covariance(kNumParameters, kNumParameters), 0.0);
  EXPECT_TRUE(std::isnan(fit.covariance(kNumParameters + 1, kNumParameters + 1)));
}

// However often it is carried on from where it ended.
TEST(FitStructure, KeepsTheInertiaAboveTheLeast) {
  const std::vector<Log> logs = {LogOf(Short(), 4)};
  const double least = 1.5 * kSurgeTruth.inertia;
  const TrainingData data(MeasuredSegmentsOf(logs, Dof::kSurge).all, kSurgeTruth, least);
  const Whitener whitener(Coloured(), data.samples());
  ExtendedModel model = {kSurgeTruth, {}};
  for (int turn = 0; turn < 3; ++turn) {
    const StructureFit fit = FitStructure(data, model, StatesOf(data), whitener);
    ASSERT_TRUE(fit.converged);
    EXPECT_EQ(fit.model.baseline.inertia, least);
    EXPECT_TRUE(fit.is_on_bound[kInertia]);
    model = fit.model;
  }
}

TEST(FitStructure, SaysThatAModelCannotBeSimulated) {
  const TrainingData data = DataOf(Short(), 1);
  const Whitener whitener(Coloured(), data.samples());
  ExtendedModel runaway = {{1e-6, 0.0, -1e6, 0.0}, {}};
  runaway.baseline.linear_damping = 1e9;
  const StructureFit fit = FitStructure(data, runaway, StatesOf(data), whitener);
  EXPECT_FALSE(fit.converged);
  EXPECT_EQ(fit.jacobian.size(), 0);
}

// The reported covariance is a promise about the spread over repeated runs, colour included.
TEST(FitStructureAndNoise, HasACovarianceThatMatchesTheSpreadOverRepeatedRuns) {
  const int num_runs = 30;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (int seed = 0; seed < num_runs; ++seed) {
    const TrainingData data = DataOf(Short(), 100 + seed);
    const StructureFit fit = FitBaseline(data, {kSurgeTruth, {}}, StatesOf(data));
    ASSERT_TRUE(fit.converged);
    for (int k = 0; k < kNumParameters; ++k) {
      const double miss = ToVector(fit.model.baseline)[k] - ToVector(kSurgeTruth)[k];
      sum[k] += miss * miss / fit.covariance(k, k) / num_runs;
    }
  }
  // Means of 30 chi squared: 1, give or take sqrt(2 / 30) = 0.26. White noise of the same size
  // would give (1 + 0.8) / (1 - 0.8) = 9 at the slow end.
  for (int k = 0; k < kNumParameters; ++k) EXPECT_NEAR(sum[k], 1.0, 4.0 * 0.26) << k;
}

// Without sensor noise all that a baseline leaves is what it lacks. Its noise is that, not what the
// model's derivatives promise and the model does not reach.
TEST(FitBaseline, LeavesWhatItsNoiseAllowsThoughTheDataHaveNone) {
  SurgeRun run;
  run.input = Square(60.0, 20.0);
  run.velocity_noise = 0.0;
  run.effects = "position_stiffness:stiffness=100";
  const TrainingData data = DataOf(run, 1);
  const StructureFit fit = FitBaseline(data, {kSurgeTruth, {}}, StatesOf(data));
  ASSERT_TRUE(fit.IsSimulated());
  EXPECT_LT(fit.chi_squared, 2.0 * static_cast<double>(data.bins().size()));
}

}  // namespace
}  // namespace fathom
