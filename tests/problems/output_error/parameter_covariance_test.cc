// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/parameter_covariance.h"

#include "fathom/solve/decompositions.h"

#include <cmath>
#include <limits>
#include <vector>

#include "synthetic_run.h"
#include <Eigen/Core>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// 900 s at 10 Hz, more samples than are simulated at once, with two gaps.
Segment LongSegmentWithGaps() {
  SyntheticRun run = {.command = Multisine};
  run.duration = 900.0;
  run.noise = 0.01;
  run.noise_correlation = 0.8;
  Segment segment = Synthesize(run, 1);
  for (auto* column : {&segment.time, &segment.velocity, &segment.position}) {
    column->erase(column->begin() + 5000, column->begin() + 5040);
    column->erase(column->begin() + 100, column->begin() + 105);
  }
  return segment;
}

// docs/output_error.md (7) written out over the whole segment, with one simulation and plain
// matrices: A and B of the parameters after elimination of the initial state.
void WriteOut(const UncoupledModel<double>& model,
              const Segment& segment,
              const InitialState& initial,
              FittedOutput output,
              const Autoregression& noise,
              Eigen::MatrixXd* A,
              Eigen::MatrixXd* B) {
  const auto n = static_cast<Eigen::Index>(segment.time.size());
  std::vector<double> derivatives(5 * n), v(n), x(n);
  const std::span<double> none;
  const bool is_velocity = output == FittedOutput::kVelocity;
  ASSERT_TRUE(Simulation(segment.command, segment.time)
                  .RunWithSensitivities(model,
                                        initial,
                                        v,
                                        x,
                                        is_velocity ? std::span(derivatives) : none,
                                        is_velocity ? none : std::span(derivatives)));
  Eigen::MatrixXd J = Eigen::MatrixXd::Ones(n, 4 + StateSize(output));
  for (Eigen::Index i = 0; i < n; ++i) {
    for (int j = 0; j < 5; ++j) J(i, j) = derivatives[5 * i + j];
  }
  // What the initial state cannot imitate.
  const Eigen::MatrixXd states = J.rightCols(StateSize(output));
  const Eigen::MatrixXd rest = J.leftCols(4) - states * LeastSquares(states, J.leftCols(4));
  *A = rest.transpose() * rest;
  *B = Eigen::MatrixXd::Zero(4, 4);
  ColouredGram coloured(noise, 4);
  for (Eigen::Index begin = 0, i = 1; i <= n; ++i) {
    if (i < n && segment.time[i] - segment.time[i - 1] < 0.15) continue;
    coloured.Add(rest.middleRows(begin, i - begin));
    *B += coloured.EndPiece();
    begin = i;
  }
}

void ExpectWhatTheFormulasSay(FittedOutput output) {
  const UncoupledModel<double> model = SyntheticRun{}.truth;
  const InitialState initial = {0.1, -0.2};
  const std::vector<Segment> segments = {LongSegmentWithGaps()};
  const auto evidence =
      EvidenceAt(std::vector{model}, segments, std::vector{initial}, output, 1.0, kInfinity);
  ASSERT_GT(evidence.noise.order(), 0);
  Eigen::MatrixXd A, B;
  WriteOut(model, segments[0], initial, output, evidence.noise, &A, &B);
  const Eigen::MatrixXd inverse = InverseOfSymmetric(A);
  const Eigen::MatrixXd expected = inverse * B * inverse;
  // The freedom factor is one number for all of them, at most 1 + unknowns / unknowns, but for how
  // far rounding takes the two ways of summing up apart.
  const double freedom = evidence.covariance(0, 0) / expected(0, 0);
  EXPECT_GT(freedom, 1.0);
  EXPECT_LE(freedom, 2.0 + 1e-10);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double size = std::sqrt(evidence.covariance(i, i) * evidence.covariance(j, j));
      EXPECT_NEAR(evidence.covariance(i, j), freedom * expected(i, j), 1e-7 * size);
    }
  }
}

TEST(EvidenceAt, IsThatOfTheWholeSegmentThoughItIsSimulatedInStretches) {
  ExpectWhatTheFormulasSay(FittedOutput::kVelocity);
}

TEST(EvidenceAt, IsThatOfTheWholeSegmentForPositionsAsWell) {
  ExpectWhatTheFormulasSay(FittedOutput::kPosition);
}

// A segment far off says nothing about the parameters, and must not spoil what the other one says.
TEST(EvidenceAt, TakesASegmentWithEverySampleClipped) {
  for (const auto output : {FittedOutput::kVelocity, FittedOutput::kPosition}) {
    SyntheticRun run = {.command = Multisine};
    run.noise = 0.01;
    std::vector<Segment> segments = {Synthesize(run, 1), Synthesize(run, 2)};
    const std::vector<InitialState> states(2);
    const std::vector truth(2, run.truth);
    const auto alone = EvidenceAt(truth, std::span(segments).first(1), states, output, 0.01, 3.0);
    for (double& v : segments[1].velocity) v += 100.0;
    for (double& x : segments[1].position) x += 100.0;
    const auto both = EvidenceAt(truth, segments, states, output, 0.01, 3.0);
    EXPECT_DOUBLE_EQ(both.condition_number, alone.condition_number);
    for (int i = 0; i < kNumParameters; ++i) {
      EXPECT_DOUBLE_EQ(both.share[i], alone.share[i]);
      EXPECT_DOUBLE_EQ(both.change_per_second_of_offset[i], alone.change_per_second_of_offset[i]);
      EXPECT_TRUE(std::isfinite(both.covariance(i, i)));
      EXPECT_GT(both.covariance(i, i), alone.covariance(i, i));
    }
  }
}

// A linear vehicle on the orbit of a sampled sine: the response is a sampled sine as well, and a
// delay turns it exactly as inertia and linear damping can.
TEST(EvidenceAt, SaysThatADelayLeavesTheParametersUnknownWhereTheyImitateIt) {
  const UncoupledModel<double> model = {100.0, 0.0, 40.0, 0.0};
  Segment segment;
  const int period = 100, num_samples = 2000;
  for (int i = 0; i < num_samples; ++i) {
    segment.time.push_back(0.1 * i);
    segment.command.time.push_back(0.1 * i);
    segment.command.value.push_back(50.0 * std::sin(2.0 * M_PI * i / period));
  }
  // After many time constants of 2.5 s the run is on the orbit, where a whole period brings it
  // back.
  std::vector<double> v(num_samples);
  const Simulation simulation(segment.command, segment.time);
  ASSERT_TRUE(simulation.Run(model, {0.0, 0.0}, v, {}));
  const InitialState on_orbit = {v[15 * period], 0.0};
  ASSERT_TRUE(simulation.Run(model, on_orbit, v, {}));
  segment.velocity = v;
  for (int i = 0; i < num_samples; ++i) segment.velocity[i] += 0.01 * std::sin(2.3 * i * i);
  const std::vector<Segment> segments = {segment};
  const auto evidence = EvidenceAt(std::vector{model},
                                   segments,
                                   std::vector{on_orbit},
                                   FittedOutput::kVelocity,
                                   0.01,
                                   kInfinity);
  EXPECT_TRUE(std::isfinite(evidence.covariance(kInertia, kInertia)));
  EXPECT_EQ(evidence.share_with_time_offset[kInertia], 0.0);
  EXPECT_EQ(evidence.covariance_with_time_offset(kInertia, kInertia), kInfinity);
  EXPECT_TRUE(std::isfinite(evidence.change_per_second_of_offset[kInertia]));
}

}  // namespace
}  // namespace fathom
