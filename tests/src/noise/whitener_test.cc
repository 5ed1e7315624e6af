// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/whitener.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "dense_covariance.h"
#include <gtest/gtest.h>
#include <unsupported/Eigen/MatrixFunctions>

namespace fathom {
namespace {

struct Case {
  std::string name;
  NoiseModel model;
  std::vector<NoiseSample> samples;
};

NoiseModel Full() {
  NoiseModel model;
  model.velocity = {.white_std = 0.02, .coloured = {.std = 0.013, .time = 0.9}};
  model.displacement = {.white_std = 0.01, .coloured = {.std = 0.03, .time = 2.5}};
  model.disturbance = {.std = 0.006, .time = 4.0};
  model.damping_rate = 0.11;
  return model;
}

// Two segments of both channels, irregular, with gaps, samples at the same time, and bins that
// averaged less than others.
std::vector<NoiseSample> IrregularSamples(int n) {
  std::mt19937 generator(5);
  std::vector<NoiseSample> samples;
  double time = 3.0;
  for (int i = 0; i < n; ++i) {
    NoiseSample sample{.time = time};
    sample.channel = generator() % 3 == 0 ? NoiseChannel::kDisplacement : NoiseChannel::kVelocity;
    sample.variance_factor = generator() % 5 == 0 ? 2.5 : 1.0;
    sample.segment = i < n / 3 ? 4 : 7;
    samples.push_back(sample);
    if (generator() % 4 != 0) time += 0.05 + 1e-9 * static_cast<double>(generator() % 200000000);
    if (i % 31 == 30) time += 8.0;
    if (i + 1 == n / 3) time = -20.0;
  }
  return samples;
}

// On a grid with holes, so that the filter becomes stationary and shares gains.
std::vector<NoiseSample> GridSamples(int n, bool has_displacement) {
  std::vector<NoiseSample> samples;
  for (int i = 0; static_cast<int>(samples.size()) < n; ++i) {
    if (i % 97 > 90) continue;
    samples.push_back({.time = 0.2 * i});
    if (!has_displacement) continue;
    samples.push_back({.time = 0.2 * i, .channel = NoiseChannel::kDisplacement});
  }
  return samples;
}

std::vector<Case> Cases() {
  NoiseModel white, coloured = Full(), disturbed = Full(), only_coloured = Full();
  white.velocity.white_std = 0.3;
  coloured.disturbance.std = 0.0;
  disturbed.velocity.coloured.std = disturbed.displacement.coloured.std = 0.0;
  only_coloured.velocity.white_std = only_coloured.displacement.white_std = 0.0;
  NoiseModel velocity_coloured = Full(), displacement_coloured = Full();
  displacement_coloured.velocity.coloured.std = 0.0;
  velocity_coloured.displacement.coloured.std = 0.0;
  const auto irregular = IrregularSamples(150);
  const auto both = GridSamples(600, true), velocity = GridSamples(600, false);
  auto displacement = velocity;
  for (NoiseSample& sample : displacement) sample.channel = NoiseChannel::kDisplacement;
  return {{"white, velocity", white, velocity},
          {"all, irregular", Full(), irregular},
          {"coloured, irregular", coloured, irregular},
          {"disturbed, irregular", disturbed, irregular},
          {"no white noise, both on a grid", only_coloured, both},
          {"coloured velocity, irregular", velocity_coloured, irregular},
          {"coloured displacement, irregular", displacement_coloured, irregular},
          {"all, both on a grid", Full(), both},
          {"all, velocity on a grid", Full(), velocity},
          {"disturbed, velocity on a grid", disturbed, velocity},
          {"coloured, velocity on a grid", coloured, velocity},
          {"all, displacement on a grid", Full(), displacement}};
}

// W S W' = I and W lower triangular make W the inverse of the Cholesky factor, a unique matrix.
TEST(Whitener, IsTheInverseCholeskyFactorOfTheDenseCovariance) {
  for (const Case& c : Cases()) {
    const Eigen::LLT<Eigen::MatrixXd> llt(DenseCovariance(c.model, c.samples));
    ASSERT_EQ(llt.info(), Eigen::Success) << c.name;
    const auto n = static_cast<Eigen::Index>(c.samples.size());
    const Whitener whitener(c.model, c.samples);
    RowMajorMatrix W = RowMajorMatrix::Identity(n, n);
    whitener.Apply(W, W);
    const Eigen::MatrixXd L = llt.matrixL();
    EXPECT_LT((W * L - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-9) << c.name;
    EXPECT_NEAR(whitener.log_determinant(), 2.0 * L.diagonal().array().log().sum(), 1e-9 * n)
        << c.name;
  }
}

// Covariance of the samples of one segment by the exponential of van Loan's matrix, interval by
// interval, each at its own damping rate.
Eigen::MatrixXd CovarianceByVanLoan(const NoiseModel& model,
                                    const std::vector<NoiseSample>& samples) {
  using Matrix = Eigen::Matrix<double, 3, 3>;  // of (w, v', x')
  const double b = 1.0 / model.disturbance.time, w2 = std::pow(model.disturbance.std, 2);
  const double usual = model.damping_rate;
  const auto n = static_cast<Eigen::Index>(samples.size());
  Matrix P = Matrix::Zero();
  P(0, 0) = w2;
  P(0, 1) = P(1, 0) = w2 / (usual + b);
  P(1, 1) = P(0, 1) / usual;
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(n, n);
  std::vector<Eigen::Vector3d> carried;  // covariance of the state now with each sample before
  for (Eigen::Index i = 0; i < n; ++i) {
    const NoiseSample& sample = samples[i];
    if (i > 0) {
      const double a = usual * sample.damping_factor;
      Matrix A = Matrix::Zero(), G = Matrix::Zero();
      A << -b, 0, 0, 1, -a, 0, 0, 1, 0;
      G(0, 0) = 2.0 * b * w2;
      Eigen::Matrix<double, 6, 6> block = Eigen::Matrix<double, 6, 6>::Zero();
      block.topLeftCorner<3, 3>() = -A;
      block.topRightCorner<3, 3>() = G;
      block.bottomRightCorner<3, 3>() = A.transpose();
      const Eigen::Matrix<double, 6, 6> exponential =
          (block * (sample.time - samples[i - 1].time)).exp();
      const Matrix F = exponential.bottomRightCorner<3, 3>().transpose();
      P = F * P * F.transpose() + F * exponential.topRightCorner<3, 3>();
      for (Eigen::Vector3d& covariance : carried) covariance = F * covariance;
    }
    const int seen = sample.channel == NoiseChannel::kVelocity ? 1 : 2;
    for (Eigen::Index j = 0; j < i; ++j) S(i, j) = S(j, i) = carried[j](seen);
    const SensorNoise& sensor = seen == 1 ? model.velocity : model.displacement;
    S(i, i) = P(seen, seen) + sample.variance_factor * std::pow(sensor.white_std, 2);
    carried.emplace_back(P.col(seen));
  }
  return S;
}

TEST(Whitener, FollowsADampingRateThatChangesFromSampleToSample) {
  NoiseModel model = Full();
  model.velocity.coloured.std = model.displacement.coloured.std = 0.0;
  model.disturbance.std = 0.05;
  std::mt19937 generator(11);
  for (auto samples : {IrregularSamples(120), GridSamples(200, true)}) {
    for (NoiseSample& sample : samples) {
      sample.segment = 0;
      sample.damping_factor = std::exp2(0.5 * (static_cast<int>(generator() % 9) - 4));
    }
    std::sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) {
      return a.time < b.time;
    });
    const Eigen::MatrixXd S = CovarianceByVanLoan(model, samples);
    const auto n = static_cast<Eigen::Index>(samples.size());
    RowMajorMatrix W = RowMajorMatrix::Identity(n, n);
    Whitener(model, samples).Apply(W, W);
    EXPECT_LT((W * S * W.transpose() - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(),
              1e-8);
  }
}

TEST(Whitener, LogLikelihoodIsThatOfTheDenseGaussian) {
  for (const Case& c : Cases()) {
    const Eigen::MatrixXd S = DenseCovariance(c.model, c.samples);
    const Eigen::LLT<Eigen::MatrixXd> llt(S);
    const Eigen::VectorXd e = DenseDraws(c.model, c.samples, 8).Draw();
    const double n = static_cast<double>(e.size());
    const Eigen::MatrixXd L = llt.matrixL();
    const double expected = -0.5 * (e.dot(llt.solve(e)) + 2.0 * L.diagonal().array().log().sum() +
                                    n * std::log(2.0 * std::numbers::pi));
    EXPECT_NEAR(Whitener(c.model, c.samples).LogLikelihood(Span(e)), expected, 1e-7 * n) << c.name;
  }
}

TEST(Whitener, GivesTheSameForOneColumnAndForMany) {
  const auto samples = IrregularSamples(150);
  const Whitener whitener(Full(), samples);
  const RowMajorMatrix block = RowMajorMatrix::Random(150, 15);  // chunks of 8, 4 and 1
  RowMajorMatrix whitened(150, 15);
  whitener.Apply(block, whitened);
  for (int k = 0; k < 15; ++k) {
    const Eigen::VectorXd column = block.col(k);
    Eigen::VectorXd out(150);
    whitener.Apply(Span(column), {out.data(), 150});
    EXPECT_EQ((out - whitened.col(k)).cwiseAbs().maxCoeff(), 0.0);
  }
}

TEST(Whitener, IsIndifferentToWhenASegmentStarts) {
  auto samples = IrregularSamples(150);
  const Eigen::VectorXd e = Eigen::VectorXd::Random(150);
  const double before = Whitener(Full(), samples).LogLikelihood(Span(e));
  for (NoiseSample& sample : samples) sample.time += sample.segment == 4 ? 512.0 : -64.0;
  EXPECT_NEAR(Whitener(Full(), samples).LogLikelihood(Span(e)), before, 1e-6);
}

TEST(Whitener, WhitensManyColumnsInNanoseconds) {
  const auto samples = GridSamples(3000, true);
  const Whitener whitener(Full(), samples);
  RowMajorMatrix block = RowMajorMatrix::Random(3000, 304), out = block;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 5; ++i) whitener.Apply(block, out);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double nanoseconds = 1e9 * seconds / (5.0 * 3000.0 * 304.0);
  std::printf("%.1f ns per sample and column\n", nanoseconds);
  RecordProperty("nanoseconds", std::to_string(nanoseconds));
  EXPECT_TRUE(out.allFinite());
}

// The setting up of the gains, which a fit does again and again.
TEST(Whitener, SetsUpInMicroseconds) {
  for (const Case& c : {Case{"grid", Full(), GridSamples(3000, true)},
                        Case{"irregular", Full(), IrregularSamples(3000)}}) {
    const auto start = std::chrono::steady_clock::now();
    double sum = 0.0;
    for (int i = 0; i < 20; ++i) sum += Whitener(c.model, c.samples).log_determinant();
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%s: %.0f ns per sample\n", c.name.c_str(), 1e9 * seconds / (20.0 * 3000.0));
    EXPECT_TRUE(std::isfinite(sum));
  }
}

TEST(WhitenerDeathTest, RefusesSamplesOutOfOrderOrWithoutVariance) {
  NoiseModel model = Full();
  const std::vector<NoiseSample> backwards = {{.time = 1.0}, {.time = 0.5}};
  EXPECT_DEATH(Whitener(model, backwards), "out of order at time 0.5");
  const std::vector<NoiseSample> samples = {{.time = 1.0}, {.time = 1.5}};
  EXPECT_DEATH(Whitener(NoiseModel{}, samples), "without a variance of its own");
  model.damping_rate = 0.0;
  EXPECT_DEATH(Whitener(model, samples), "not stationary");
}

}  // namespace
}  // namespace fathom
