// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/screen.h"

#include "fathom/base/random_stream.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <vector>

#include "dense_noise.h"
#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr int kRows = 150;

// A fit and four trials of three suspects made of smooth random columns.
struct Made {
  StructureFit fit;
  Trials trials;
  NoiseModel noise;
  std::vector<NoiseSample> samples;
  Eigen::MatrixXd S;

  explicit Made(std::uint64_t seed) {
    RandomStream random(seed, "test");
    const auto smooth = [&] {
      Eigen::VectorXd column(kRows);
      double value = 0.0;
      for (double& number : column) number = value = 0.9 * value + random.Normal();
      return column;
    };
    noise.velocity = {.white_std = 0.5, .coloured = {.std = 0.8, .time = 1.1}};
    for (int i = 0; i < kRows; ++i) {
      samples.push_back({.time = 0.2 * i + 0.01 * (i % 3), .variance_factor = 1.0 + i % 2});
    }
    S = DenseCovariance(noise, samples);
    fit.residual = smooth();
    fit.jacobian.resize(kRows, 3);
    for (int k = 0; k < 3; ++k) fit.jacobian.col(k) = 1e3 * smooth();
    // Two-sided, one-sided, two amounts at once, and a second one of the first suspect.
    trials.trials = {{.suspect = 0, .values = {1.0}, .amounts = {0}, .any_sign = true},
                     {.suspect = 1, .values = {1.0}, .amounts = {0}, .any_sign = false},
                     {.suspect = 2, .values = {1.0, 1.0}, .amounts = {0, 1}, .any_sign = true},
                     {.suspect = 0, .values = {2.0}, .amounts = {0}, .any_sign = true}};
    trials.trials[1].first_column = 1;
    trials.trials[2].first_column = 2;
    trials.trials[2].num_columns = 2;
    trials.trials[3].first_column = 4;
    trials.signatures.resize(kRows, 5);
    for (int k = 0; k < 5; ++k) trials.signatures.col(k) = 0.01 * smooth();
  }

  // Chi squared after dense generalised least squares on the fit's columns and these of the
  // trials'.
  DenseFit Solve(const std::vector<int>& columns) const {
    Eigen::MatrixXd X(kRows, 3 + columns.size());
    X.leftCols(3) = fit.jacobian;
    for (size_t k = 0; k < columns.size(); ++k) {
      X.col(3 + static_cast<Eigen::Index>(k)) = trials.signatures.col(columns[k]);
    }
    return FitDense(S, X, fit.residual);
  }
  double Gain(const std::vector<int>& columns) const {
    return Solve({}).chi_squared - Solve(columns).chi_squared;
  }
};

TEST(Screen, ScoresWhatDenseLeastSquaresGains) {
  for (int seed = 0; seed < 5; ++seed) {
    Made made(seed);
    if (made.Solve({1}).solution[3] < 0.0) made.trials.signatures.col(1) *= -1.0;
    const Screen screen(made.fit, &made.trials, Whitener(made.noise, made.samples));
    const std::vector<int> columns[] = {{0}, {1}, {2, 3}, {4}};
    for (int t = 0; t < 4; ++t) {
      const double gain = made.Gain(columns[t]);
      EXPECT_NEAR(screen.scores()[t], gain, 1e-7 * (1.0 + gain)) << t;
      const Eigen::VectorXd solution = made.Solve(columns[t]).solution.tail(columns[t].size());
      for (size_t k = 0; k < columns[t].size(); ++k) {
        EXPECT_NEAR(screen.amounts()[t][k], solution[k], 1e-6 * solution.norm()) << t;
      }
    }
  }
}

TEST(Screen, ScoresPairsAsDenseLeastSquaresOnBothDoes) {
  for (int seed = 0; seed < 5; ++seed) {
    const Made made(seed);
    const Screen screen(made.fit, &made.trials, Whitener(made.noise, made.samples));
    const Eigen::MatrixXd scores = screen.PairScores({0, 1, 2, 3});
    EXPECT_NEAR(scores(0, 1), made.Gain({0, 1}), 1e-6);
    EXPECT_NEAR(scores(0, 2), made.Gain({0, 2, 3}), 1e-6);
    EXPECT_NEAR(scores(2, 3), made.Gain({2, 3, 4}), 1e-6);
    EXPECT_EQ(scores(2, 0), scores(0, 2));
  }
}

TEST(Screen, GivesAOneSidedEffectOfTheWrongSignNothing) {
  Made made(1);
  made.fit.residual = 30.0 * made.trials.signatures.col(1);
  const Whitener whitener(made.noise, made.samples);
  const Screen right(made.fit, &made.trials, whitener);
  EXPECT_NEAR(right.amounts()[1][0], 30.0, 1e-6);
  EXPECT_NEAR(right.scores()[1], made.Gain({1}), 1e-6);
  EXPECT_GT(right.scores()[1], 0.0);
  made.fit.residual *= -1.0;
  const Screen wrong(made.fit, &made.trials, whitener);
  EXPECT_EQ(wrong.scores()[1], 0.0);
}

TEST(Screen, SeesNothingInWhatTheFitCanImitate) {
  Made made(2);
  made.trials.signatures.col(0) = made.fit.jacobian * Eigen::Vector3d(0.3, -0.2, 0.7);
  const Screen screen(made.fit, &made.trials, Whitener(made.noise, made.samples));
  EXPECT_EQ(screen.scores()[0], 0.0);
  EXPECT_EQ(screen.response(0).squared, 0.0);
  const Eigen::VectorXd other = made.trials.signatures.col(1);
  const double whole = other.dot(made.S.llt().solve(other));
  EXPECT_GT(screen.response(1).squared, 0.01 * whole);
}

// Suspect 1 has one one-sided trial: zero half of the time, else chi squared of one degree. Suspect
// 2 has one trial of two amounts: chi squared of two. Suspect 0 has the greater of two that are
// about uncorrelated.
TEST(Screen, DrawsMaximaWithTheirKnownDistribution) {
  Made made(3);
  const int num_draws = 4000;
  const Eigen::MatrixXd maxima = Screen(made.fit, &made.trials, Whitener(made.noise, made.samples))
                                     .NullMaxima(num_draws, 3, 7);
  const auto share_above = [&](int suspect, double limit) {
    return (maxima.col(suspect).array() > limit).cast<double>().mean();
  };
  // Shares have a standard deviation of at most sqrt(0.25 / 4000) = 0.008.
  EXPECT_NEAR(share_above(1, 0.0), 0.5, 0.032);
  EXPECT_NEAR(share_above(1, 2.706), 0.05, 4.0 * std::sqrt(0.05 / num_draws));
  EXPECT_NEAR(share_above(2, 2.0 * std::log(10.0)), 0.1, 4.0 * std::sqrt(0.1 / num_draws));
  EXPECT_LE(share_above(0, 3.841), 1.0 - 0.95 * 0.95 + 4.0 * std::sqrt(0.1 / num_draws));
  EXPECT_GE(share_above(0, 3.841), 0.05 - 4.0 * std::sqrt(0.05 / num_draws));
}

// An effect's score is that of the likelihood: slope squared over information, with the parameters
// that are fitted following; by finite differences of simulations and dense algebra.
TEST(Screen, ScoresAnEffectAsTheSlopeOfItsLikelihoodDoes) {
  SurgeRun run;
  run.input = Multisine(80.0);
  run.duration = 60.0;
  run.rate = 5.0;
  run.effects = "thrust_asymmetry:reverse_loss=0.15";
  const std::vector<Log> logs = {LogOf(run, 1)};
  const TrainingData data(MeasuredSegmentsOf(logs, Dof::kSurge).all);
  NoiseModel noise;
  noise.velocity = {.white_std = 0.008, .coloured = {.std = 0.006, .time = 0.7}};
  const Whitener whitener(noise, data.samples());
  const std::vector<InitialState> start = {data.segments()[0].initial};
  const StructureFit fit = FitStructure(data, {kSurgeTruth, {}}, start, whitener);
  ASSERT_TRUE(fit.converged);
  const Eigen::LLT<Eigen::MatrixXd> factor(DenseCovariance(noise, data.samples()));

  std::vector<Suspect> suspects;
  for (const char* name : {"thrust_asymmetry",
                           "thrust_inflow_loss",
                           "damping_asymmetry",
                           "cubic_damping",
                           "coulomb_friction",
                           "steady_current",
                           "position_stiffness",
                           "buoyancy_drift",
                           "sensor_bias"}) {
    suspects.push_back({FindEffect(name), {}});
  }
  const Trials trials = TrialsAbout(data, fit, suspects);
  const Screen screen(fit, &trials, whitener);
  ASSERT_EQ(trials.trials.size(), suspects.size());
  for (size_t t = 0; t < suspects.size(); ++t) {
    const EffectInfo& info = suspects[t].effect->info();
    // Small enough for the simulation to be linear in it; large enough for its steps, which are
    // divided anew (1e-7).
    const double step = 0.01 * std::abs(trials.trials[t].values[0] - info.parameters[0].null);
    const auto simulate = [&](double change) {
      const double value = info.parameters[0].null + change;
      return *data.Simulate(WithEffect(fit.model, {suspects[t].effect, {}, {value}}), fit.initial);
    };
    const Eigen::VectorXd low = simulate(-step), high = simulate(step);
    const Eigen::VectorXd signature = (high - low) / (2.0 * step);
    const DenseFit imitated = FitDense(factor.reconstructedMatrix(), fit.jacobian, signature);
    const Eigen::VectorXd own = signature - fit.jacobian * imitated.solution;
    const double slope = own.dot(factor.solve(fit.residual));
    const double z = slope / std::sqrt(imitated.chi_squared);
    // A probe of a fiftieth is a secant, and the linearised response good to 1 %
    // (force_response_test): 2 % of the signature, which is 2 % over its share of what survives.
    // That error meets noise of standard deviation 1 (three of them) and the effect itself.
    const double share = std::sqrt(imitated.chi_squared / signature.dot(factor.solve(signature)));
    const double tolerance = 0.02 / share * std::max(3.0, std::abs(z));
    if (screen.scores()[t] == 0.0) {
      EXPECT_LT(z, tolerance) << info.name;
    } else {
      EXPECT_NEAR(std::sqrt(screen.scores()[t]), std::abs(z), tolerance) << info.name;
    }
  }
  EXPECT_GT(screen.scores()[0], 25.0);  // it is there
}

}  // namespace
}  // namespace fathom
