// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/output_error.h"

#include "fathom/base/input_error.h"
#include "fathom/simulate/simulate.h"

#include <cmath>
#include <limits>
#include <vector>

#include "synthetic_run.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

constexpr UncoupledModel<double> kPoorGuess = {400.0, 20.0, 100.0, 5.0};

SyntheticRun PerfectRun() { return {.command = Multisine}; }

OutputErrorOptions FromPoorGuess() {
  OutputErrorOptions options;
  options.initial_guess = kPoorGuess;
  return options;
}

void ExpectNear(const UncoupledModel<double>& model,
                const UncoupledModel<double>& truth,
                double relative) {
  EXPECT_NEAR(model.inertia, truth.inertia, relative * truth.inertia);
  EXPECT_NEAR(model.quadratic_damping, truth.quadratic_damping, relative * truth.quadratic_damping);
  EXPECT_NEAR(model.linear_damping, truth.linear_damping, relative * truth.linear_damping);
  EXPECT_NEAR(model.buoyancy, truth.buoyancy, relative * std::abs(truth.buoyancy));
}

// Sum of squared misses, computed apart from the fit.
double SumOfSquares(const UncoupledModel<double>& model, double v0, const Segment& segment) {
  std::vector<double> v(segment.time.size());
  EXPECT_TRUE(Simulation(segment.command, segment.time).Run(model, {v0, 0.0}, v, {}));
  double sum = 0.0;
  for (size_t i = 0; i < v.size(); ++i) sum += std::pow(v[i] - segment.velocity[i], 2);
  return sum;
}

TEST(OutputError, RecoversTheTruthFromPerfectData) {
  SyntheticRun run = PerfectRun();
  run.initial_velocity = 0.3;
  const std::vector<Segment> segments = {Synthesize(run, 1)};
  const auto summary = FitOutputError(segments, FromPoorGuess());
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  ExpectNear(summary.model, run.truth, 1e-6);
  EXPECT_NEAR(summary.initial_states[0].velocity, 0.3, 1e-7);
  EXPECT_EQ(summary.initial_guess, "given");
}

TEST(OutputError, RecoversTheTruthFromPerfectPositions) {
  SyntheticRun run = PerfectRun();
  run.initial_velocity = 0.3;
  const std::vector<Segment> segments = {Synthesize(run, 1)};
  OutputErrorOptions options = FromPoorGuess();
  options.output = FittedOutput::kPosition;
  const auto summary = FitOutputError(segments, options);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  ExpectNear(summary.model, run.truth, 1e-5);
  EXPECT_NEAR(summary.initial_states[0].velocity, 0.3, 1e-6);
}

TEST(OutputError, FindsItsOwnInitialGuess) {
  SyntheticRun run = PerfectRun();
  run.noise = 0.01;
  std::vector<Segment> segments = {Synthesize(run, 3)};
  const auto summary = FitOutputError(segments);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NE(summary.initial_guess, "given");
  ExpectNear(summary.model, run.truth, 0.2);
}

TEST(OutputError, FitsSeveralLogsWithAnInitialStateEach) {
  SyntheticRun first = PerfectRun(), second = PerfectRun();
  first.duration = 60.0;
  first.initial_velocity = 0.4;
  second.start = 1000.0;
  second.duration = 90.0;
  second.initial_velocity = -0.2;
  const std::vector<Segment> segments = {Synthesize(first, 1), Synthesize(second, 2)};
  const auto summary = FitOutputError(segments, FromPoorGuess());
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  ExpectNear(summary.model, first.truth, 1e-5);
  ASSERT_EQ(summary.initial_states.size(), 2u);
  EXPECT_NEAR(summary.initial_states[0].velocity, 0.4, 1e-6);
  EXPECT_NEAR(summary.initial_states[1].velocity, -0.2, 1e-6);
}

// The optimum lies on the bound: the data come from a vehicle with *negative* quadratic damping.
// Checked against the conditions of Karush, Kuhn and Tucker on a cost computed here.
TEST(OutputError, FindsTheConstrainedOptimumOnTheBound) {
  SyntheticRun run = PerfectRun();
  run.truth.quadratic_damping = -15.0;
  run.noise = 0.005;
  const std::vector<Segment> segments = {Synthesize(run, 7)};
  OutputErrorOptions options = FromPoorGuess();
  options.huber_k = std::numeric_limits<double>::infinity();
  const auto summary = FitOutputError(segments, options);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_EQ(summary.model.quadratic_damping, 0.0);
  EXPECT_TRUE(summary.on_bound[kQuadraticDamping]);
  EXPECT_FALSE(summary.on_bound[kLinearDamping]);

  const double v0 = summary.initial_states[0].velocity;
  const double cost = SumOfSquares(summary.model, v0, segments[0]);
  const auto cost_at = [&](int index, double change) {
    ParameterVector parameters = ToVector(summary.model);
    parameters[index] += change;
    return SumOfSquares(ModelFromVector(parameters), v0, segments[0]);
  };
  // Free coordinates: no step of 1e-4 in either direction lowers the cost.
  for (const int index : {kInertia, kLinearDamping, kBuoyancy}) {
    const double step = 1e-4 * std::abs(ToVector(summary.model)[index]);
    EXPECT_GE(cost_at(index, step), cost * (1.0 - 1e-12)) << index;
    EXPECT_GE(cost_at(index, -step), cost * (1.0 - 1e-12)) << index;
  }
  // On the bound: the cost rises into the feasible side and would fall beyond it.
  EXPECT_GT(cost_at(kQuadraticDamping, 0.1), cost);
  EXPECT_LT(cost_at(kQuadraticDamping, -0.1), cost);
}

TEST(OutputError, HoldsBothDampingsAtTheBoundWhenBothWouldBeNegative) {
  SyntheticRun run = PerfectRun();
  run.truth.quadratic_damping = -3.0;
  run.truth.linear_damping = -2.0;
  run.duration = 120.0;
  const std::vector<Segment> segments = {Synthesize(run, 7)};
  const auto summary = FitOutputError(segments, FromPoorGuess());
  EXPECT_EQ(summary.model.quadratic_damping, 0.0);
  EXPECT_EQ(summary.model.linear_damping, 0.0);
  EXPECT_GT(summary.model.inertia, 0.0);
}

TEST(OutputError, MultipleShootingAgreesWithSingleShooting) {
  SyntheticRun run = PerfectRun();
  run.noise = 0.01;
  const std::vector<Segment> segments = {Synthesize(run, 5)};
  OutputErrorOptions options = FromPoorGuess();
  const auto single = FitOutputError(segments, options);
  options.shooting_window = 20.0;
  const auto multiple = FitOutputError(segments, options);
  ASSERT_TRUE(single.IsUsable() && multiple.IsUsable()) << multiple.message;
  // The ties between the windows are 1000 times tighter than the noise; what they give way is far
  // below a hundredth of a standard deviation.
  for (int i = 0; i < kNumParameters; ++i) {
    EXPECT_NEAR(ToVector(multiple.model)[i],
                ToVector(single.model)[i],
                0.01 * std::sqrt(single.covariance(i, i)));
    EXPECT_NEAR(std::sqrt(multiple.covariance(i, i) / single.covariance(i, i)), 1.0, 0.01);
  }
  EXPECT_EQ(multiple.initial_states.size(), 1u);
}

TEST(OutputError, TwoPercentOfWildSamplesMoveTheRobustFitByLessThanItsSpread) {
  SyntheticRun run = PerfectRun();
  run.noise = 0.01;
  std::vector<Segment> segments = {Synthesize(run, 5)};
  const auto clean = FitOutputError(segments, FromPoorGuess());
  for (size_t i = 10; i < segments[0].velocity.size(); i += 50) segments[0].velocity[i] += 1.0;
  const auto robust = FitOutputError(segments, FromPoorGuess());
  OutputErrorOptions plain = FromPoorGuess();
  plain.huber_k = std::numeric_limits<double>::infinity();
  const auto spoilt = FitOutputError(segments, plain);
  ASSERT_TRUE(clean.IsUsable() && robust.IsUsable());
  const double sd = std::sqrt(clean.covariance(kBuoyancy, kBuoyancy));
  EXPECT_LT(std::abs(robust.model.buoyancy - clean.model.buoyancy), 4.0 * sd);
  EXPECT_GT(std::abs(spoilt.model.buoyancy - clean.model.buoyancy), 4.0 * sd);
}

TEST(OutputError, SaysThatALogAtRestDeterminesNothing) {
  SyntheticRun run = PerfectRun();
  run.command = [](double) { return -0.81; };  // balances the buoyancy
  run.noise = 0.01;
  run.duration = 60.0;
  const std::vector<Segment> segments = {Synthesize(run, 1)};
  const auto summary = FitOutputError(segments, FromPoorGuess());
  EXPECT_FALSE(summary.IsUsable());
}

TEST(OutputError, TakesAnyShootingWindowHoweverShort) {
  SyntheticRun run = PerfectRun();
  run.duration = 10.0;
  const std::vector<Segment> segments = {Synthesize(run, 1)};
  OutputErrorOptions options = FromPoorGuess();
  options.shooting_window = 1e-9;
  options.max_iterations = 5;
  FitOutputError(segments, options);  // one window a sample at the most; comes back
}

TEST(OutputError, RefusesFewerSamplesThanUnknowns) {
  SyntheticRun run = PerfectRun();
  run.duration = 0.4;  // 5 samples, 5 unknowns
  const std::vector<Segment> segments = {Synthesize(run, 1)};
  EXPECT_THROW(FitOutputError(segments, FromPoorGuess()), InputError);
}

TEST(OutputErrorOptions, NamesEveryBrokenRule) {
  OutputErrorOptions options;
  options.huber_k = 0.0;
  options.max_iterations = -1;
  EXPECT_THAT(options.Problems(),
              ::testing::ElementsAre("huber_k is 0, expected a value above 0",
                                     "max_iterations is -1, expected a value above 0"));
  const std::vector<Segment> segments(1);
  EXPECT_THROW(FitOutputError(segments, options), InputError);
}

}  // namespace
}  // namespace fathom
