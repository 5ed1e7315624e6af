// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/fit_noise.h"

#include "fathom/solve/decompositions.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "dense_covariance.h"
#include <Eigen/Cholesky>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

RowMajorMatrix NoDesign(size_t n) { return RowMajorMatrix(static_cast<Eigen::Index>(n), 0); }

NoiseModel Disturbed() {
  NoiseModel model;
  model.velocity.white_std = 0.02;
  model.disturbance = {.std = 0.004, .time = 4.0};
  model.damping_rate = 0.1;
  return model;
}

// A constant, a slope, and slow sinusoids: as sensitivities look to slow noise.
RowMajorMatrix SlowDesign(const std::vector<NoiseSample>& samples) {
  RowMajorMatrix D(samples.size(), 6);
  for (size_t i = 0; i < samples.size(); ++i) {
    const double t = samples[i].time / 300.0;
    const double p = 2.0 * std::numbers::pi * t;
    D.row(static_cast<Eigen::Index>(i)) << 1.0, t, std::sin(p), std::cos(p), std::sin(2.0 * p),
        std::cos(2.0 * p);
  }
  return D;
}

TEST(FitNoise, FindsWhiteNoiseAlone) {
  NoiseModel white;
  white.velocity.white_std = 0.02;
  const auto samples = VelocitySamples(300.0, 0.2);
  const Eigen::VectorXd e = DenseDraws(white, samples, 1).Draw();
  FitNoiseOptions options;
  options.selection = NoiseSelection::kAic;
  const NoiseFit fit = FitNoise(samples, Span(e), NoDesign(1500), options);
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  EXPECT_EQ(fit.num_parameters, 1);
  EXPECT_FALSE(fit.model.velocity.coloured.IsPresent());
  EXPECT_FALSE(fit.model.disturbance.IsPresent());
  // Of white noise alone the maximum is the root mean square.
  EXPECT_NEAR(fit.model.velocity.white_std, std::sqrt(e.squaredNorm() / 1500.0), 1e-9);
}

TEST(FitNoise, RecoversTheParametersOfEachComponent) {
  NoiseModel coloured = Disturbed();
  coloured.disturbance.std = 0.0;
  coloured.velocity.coloured = {.std = 0.03, .time = 1.5};
  const auto samples = VelocitySamples(500.0, 0.2, [](int i) { return i % 50 > 40; });
  FitNoiseOptions options;
  options.selection = NoiseSelection::kAic;
  double log_std = 0.0, log_time = 0.0, white = 0.0, colour = 0.0, colour_time = 0.0;
  const int num_runs = 12;
  DenseDraws disturbed_draws(Disturbed(), samples, 10), coloured_draws(coloured, samples, 30);
  for (int run = 0; run < num_runs; ++run) {
    const Eigen::VectorXd e = disturbed_draws.Draw();
    const NoiseFit fit = FitNoise(samples, Span(e), NoDesign(samples.size()), options);
    ASSERT_TRUE(fit.IsUsable()) << fit.message;
    ASSERT_TRUE(fit.model.disturbance.IsPresent());
    log_std += std::log(fit.model.disturbance.std / 0.004) / num_runs;
    log_time += std::log(fit.model.disturbance.time / 4.0) / num_runs;
    white += fit.model.velocity.white_std / num_runs;
    const Eigen::VectorXd e_coloured = coloured_draws.Draw();
    const NoiseFit other = FitNoise(samples, Span(e_coloured), NoDesign(samples.size()), options);
    ASSERT_TRUE(other.IsUsable()) << other.message;
    ASSERT_TRUE(other.model.velocity.coloured.IsPresent());
    colour += other.model.velocity.coloured.std / num_runs;
    colour_time += std::log(other.model.velocity.coloured.time / 1.5) / num_runs;
  }
  // Some 40 independent stretches in 500 s leave a relative standard deviation of about 0.25 in
  // tau and 0.15 in the size, a quarter of that in the mean of 12; four of these.
  EXPECT_NEAR(log_std, 0.0, 0.20);
  EXPECT_NEAR(log_time, 0.0, 0.30);
  EXPECT_NEAR(white, 0.02, 4.0 * 0.02 / std::sqrt(2.0 * 2000.0 * num_runs));
  EXPECT_NEAR(colour, 0.03, 0.003);
  EXPECT_NEAR(colour_time, 0.0, 0.15);
}

TEST(FitNoise, RecoversBothChannelsAtOnce) {
  NoiseModel truth = Disturbed();
  truth.displacement = {.white_std = 0.005, .coloured = {.std = 0.01, .time = 2.0}};
  std::vector<NoiseSample> samples;
  for (int i = 0; i < 900; ++i) {
    samples.push_back({.time = 0.2 * i});
    samples.push_back({.time = 0.2 * i, .channel = NoiseChannel::kDisplacement});
  }
  const Eigen::VectorXd e = DenseDraws(truth, samples, 6).Draw();
  const NoiseFit fit = FitNoise(samples, Span(e), NoDesign(samples.size()), {});
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  EXPECT_NEAR(fit.model.velocity.white_std, 0.02, 4.0 * 0.02 / std::sqrt(2.0 * 900.0));
  EXPECT_NEAR(fit.model.displacement.white_std, 0.005, 0.001);
  EXPECT_NEAR(std::log(fit.model.displacement.coloured.std / 0.01), 0.0, 0.4);
  EXPECT_NEAR(std::log(fit.model.disturbance.std / 0.004), 0.0, 0.6);
  // No worse than the truth.
  EXPECT_GT(fit.log_likelihood, Whitener(truth, samples).LogLikelihood(Span(e)));
}

// Positions with white noise, begun as if it were coloured over one sample: white noise that is
// nearly absent has no slope towards more of it.
TEST(FitNoise, FindsWhiteNoiseThatItTookForShortColour) {
  NoiseModel truth = Disturbed();
  truth.displacement.white_std = 0.005;
  std::vector<NoiseSample> samples;
  for (int i = 0; i < 900; ++i) {
    samples.push_back({.time = 0.3 * i});
    samples.push_back({.time = 0.3 * i, .channel = NoiseChannel::kDisplacement});
  }
  const Eigen::VectorXd e = DenseDraws(truth, samples, 7).Draw();
  FitNoiseOptions options;
  options.start = truth;
  options.start->displacement = {.white_std = 1e-5, .coloured = {.std = 0.005, .time = 0.3}};
  const auto fitted = [&] { return FitNoise(samples, Span(e), NoDesign(samples.size()), options); };
  const double of_truth = Whitener(truth, samples).LogLikelihood(Span(e));
  EXPECT_LT(fitted().log_likelihood, of_truth - 10.0);
  options.is_thorough = true;
  const NoiseFit thorough = fitted();
  ASSERT_TRUE(thorough.IsUsable()) << thorough.message;
  EXPECT_GT(thorough.log_likelihood, of_truth);
  EXPECT_NEAR(thorough.model.displacement.white_std, 0.005, 4.0 * 0.005 / std::sqrt(2.0 * 900.0));
}

TEST(FitNoise, IsAMaximum) {
  const auto samples = VelocitySamples(300.0, 0.2);
  const Eigen::VectorXd e = DenseDraws(Disturbed(), samples, 2).Draw();
  FitNoiseOptions options;
  options.start = Disturbed();  // no coloured noise beside it
  const NoiseFit fit = FitNoise(samples, Span(e), NoDesign(1500), options);
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  EXPECT_NEAR(Whitener(fit.model, samples).LogLikelihood(Span(e)), fit.log_likelihood, 1e-6);
  for (const double factor : {0.97, 1.03}) {
    NoiseModel white = fit.model, size = fit.model, time = fit.model;
    white.velocity.white_std *= factor;
    size.disturbance.std *= factor;
    time.disturbance.time *= factor;
    for (const NoiseModel& other : {white, size, time}) {
      EXPECT_LT(Whitener(other, samples).LogLikelihood(Span(e)), fit.log_likelihood + 2e-4);
    }
  }
}

// The restricted likelihood is that of an orthonormal base of what the design leaves: independent
// of the code, with dense matrices.
TEST(FitNoise, RestrictedLikelihoodIsThatOfTheComplement) {
  const auto samples = VelocitySamples(60.0, 0.2);
  const RowMajorMatrix D = SlowDesign(samples);
  const Eigen::Index n = D.rows();
  const Eigen::VectorXd e = DenseDraws(Disturbed(), samples, 2).Draw();
  const NoiseFit fit = FitNoise(samples, Span(e), D, {});
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  const Eigen::MatrixXd dense = D;
  const Eigen::MatrixXd Q = PivotedQr(dense).QTimes(Eigen::MatrixXd::Identity(n, n));
  const Eigen::MatrixXd base = Q.rightCols(n - D.cols());
  const Eigen::MatrixXd S = base.transpose() * DenseCovariance(fit.model, samples) * base;
  const Eigen::LLT<Eigen::MatrixXd> llt(S);
  const Eigen::VectorXd left = base.transpose() * e;
  const Eigen::MatrixXd L = llt.matrixL();
  const double expected =
      -0.5 * (left.dot(llt.solve(left)) + 2.0 * L.diagonal().array().log().sum() +
              static_cast<double>(left.size()) * std::log(2.0 * std::numbers::pi));
  EXPECT_NEAR(fit.log_likelihood, expected, 1e-6);
}

TEST(FitNoise, DoesNotCareForThePartInTheDesignNorForItsUnits) {
  const auto samples = VelocitySamples(100.0, 0.2);
  RowMajorMatrix D = SlowDesign(samples);
  const Eigen::VectorXd e = DenseDraws(Disturbed(), samples, 4).Draw();
  const NoiseFit fit = FitNoise(samples, Span(e), D, {});
  const Eigen::VectorXd moved = e + D * Eigen::VectorXd::LinSpaced(6, -1.0, 2.0);
  RowMajorMatrix more(D.rows(), 7);
  more << 1e6 * D.col(0), 1e-6 * D.col(1), D.rightCols(4), D.col(2) + 3.0 * D.col(4);
  const NoiseFit other = FitNoise(samples, Span(moved), more, {});
  EXPECT_NEAR(other.log_likelihood, fit.log_likelihood, 1e-3);
  EXPECT_NEAR(other.model.velocity.white_std, fit.model.velocity.white_std, 1e-4);
}

// Six slow columns take a good part of slow noise with them; only the restricted likelihood knows.
TEST(FitNoise, RestrictedLikelihoodRemovesTheBiasOfFittedColumns) {
  NoiseModel truth = Disturbed();
  truth.disturbance = {.std = 0.002, .time = 20.0};
  const auto samples = VelocitySamples(300.0, 0.4);
  const RowMajorMatrix D = SlowDesign(samples);
  const Eigen::MatrixXd dense = D;
  const PivotedQr qr(dense);
  DenseDraws draws(truth, samples, 4);
  double plain = 0.0, restricted = 0.0;
  const int num_runs = 60;
  for (int run = 0; run < num_runs; ++run) {
    Eigen::VectorXd e = draws.Draw();
    e -= dense * qr.Solve(e);
    FitNoiseOptions options;
    options.start = truth;  // no coloured noise beside the disturbance
    const NoiseFit ml = FitNoise(samples, Span(e), NoDesign(samples.size()), options);
    const NoiseFit reml = FitNoise(samples, Span(e), D, options);
    ASSERT_TRUE(ml.IsUsable() && reml.IsUsable());
    plain += std::log(ml.model.DisturbedVelocityStd() / truth.DisturbedVelocityStd()) / num_runs;
    restricted +=
        std::log(reml.model.DisturbedVelocityStd() / truth.DisturbedVelocityStd()) / num_runs;
  }
  std::printf("log of the size over the truth: ML %.2f, REML %.2f\n", plain, restricted);
  EXPECT_LT(plain, -0.2);
  EXPECT_LT(std::abs(restricted), 0.5 * std::abs(plain));
}

TEST(FitNoise, SeveralSegmentsCountTogether) {
  auto samples = VelocitySamples(100.0, 0.2);
  const auto one = samples;
  for (int segment = 1; segment < 5; ++segment) {
    for (NoiseSample sample : one) {
      sample.segment = segment;
      samples.push_back(sample);
    }
  }
  const Eigen::VectorXd e = DenseDraws(Disturbed(), samples, 4).Draw();
  const NoiseFit fit = FitNoise(samples, Span(e), NoDesign(samples.size()), {});
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  EXPECT_NEAR(std::log(fit.model.disturbance.std / 0.004), 0.0, 0.6);
  EXPECT_LE(fit.model.disturbance.time, 25.0 * 1.0001);  // a quarter of one segment
}

TEST(FitNoise, StartsWarmInTheSamePlaceAndRepeatsItself) {
  const auto samples = VelocitySamples(300.0, 0.2);
  const RowMajorMatrix D = SlowDesign(samples);
  const Eigen::VectorXd e = DenseDraws(Disturbed(), samples, 5).Draw();
  const auto timed = [&](const FitNoiseOptions& options, NoiseFit* fit) {
    const auto start = std::chrono::steady_clock::now();
    *fit = FitNoise(samples, Span(e), D, options);
    return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  NoiseFit cold, again, warm;
  const double cold_time = timed({}, &cold);
  timed({}, &again);
  FitNoiseOptions options;
  options.start = cold.model;
  options.start->disturbance.std *= 1.2;
  options.start->velocity.white_std *= 0.95;
  const double warm_time = timed(options, &warm);
  std::printf("cold %.1f ms (%d evaluations), warm %.1f ms (%d)\n",
              cold_time,
              cold.num_evaluations,
              warm_time,
              warm.num_evaluations);
  EXPECT_EQ(again.log_likelihood, cold.log_likelihood);
  EXPECT_NEAR(warm.log_likelihood, cold.log_likelihood, 1e-3);
  EXPECT_EQ(warm.num_parameters, cold.num_parameters);
  EXPECT_LT(warm.num_evaluations, cold.num_evaluations / 2);
}

TEST(FitNoise, SaysWhyThereIsNoFit) {
  EXPECT_FALSE(NoiseFit().IsUsable());
  const auto samples = VelocitySamples(3.0, 0.2);
  const Eigen::VectorXd e = Eigen::VectorXd::Random(15);
  EXPECT_THAT(FitNoise(samples, Span(e), NoDesign(15), {}).message, HasSubstr("Too few samples"));
  const auto longer = VelocitySamples(30.0, 0.2);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(150);
  EXPECT_THAT(FitNoise(longer, Span(zero), NoDesign(150), {}).message,
              HasSubstr("zero throughout"));
  FitNoiseOptions options;
  options.damping_rate = 0.0;
  EXPECT_THAT(FitNoise(longer, Span(zero), NoDesign(150), options).message,
              HasSubstr("damping_rate must be above 0"));
}

}  // namespace
}  // namespace fathom
