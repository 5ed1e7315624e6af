// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/smooth_disturbance.h"

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "dense_covariance.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

NoiseModel SmoothlyDisturbed() {
  NoiseModel model;
  model.velocity = {.white_std = 0.02, .coloured = {.std = 0.01, .time = 0.8}};
  model.displacement = {.white_std = 0.015, .coloured = {.std = 0.008, .time = 1.3}};
  model.disturbance = {.std = 0.008, .time = 5.0};
  model.damping_rate = 0.12;
  return model;
}

// Both channels, irregular, two segments.
std::vector<NoiseSample> Samples(int n) {
  std::mt19937 generator(9);
  std::vector<NoiseSample> samples;
  double time = 1.0;
  for (int i = 0; i < n; ++i) {
    samples.push_back(
        {.time = time,
         .channel = i % 3 == 0 ? NoiseChannel::kDisplacement : NoiseChannel::kVelocity,
         .variance_factor = i % 7 == 0 ? 3.0 : 1.0,
         .segment = i < n / 3 ? 0 : 1});
    time += 0.04 + 1e-3 * static_cast<double>(generator() % 300);
    if (i % 40 == 39) time += 6.0;
  }
  return samples;
}

// Covariance of w(s) with v'(t), by the solution of dv'/dt = -a v' + w: the past of w weighs in
// with exp(-a age). Its integral over t is the covariance with x'.
class CrossCovariance {
 public:
  explicit CrossCovariance(const NoiseModel& model)
      : variance_(model.disturbance.std * model.disturbance.std),
        a_(model.damping_rate),
        b_(1.0 / model.disturbance.time) {}

  double WithVelocity(double s, double t) const {
    if (t <= s) return variance_ * std::exp(-b_ * (s - t)) / (a_ + b_);
    const double u = t - s;
    return variance_ *
           (std::exp(-a_ * u) / (a_ + b_) + (std::exp(-b_ * u) - std::exp(-a_ * u)) / (a_ - b_));
  }

  // Simpson's rule on either side of the kink at t = s.
  double WithDisplacement(double s, double t) const {
    return t <= s ? Integral(s, 0.0, t) : Integral(s, 0.0, s) + Integral(s, s, t);
  }

 private:
  double Integral(double s, double from, double to) const {
    const int n = 400;
    double sum = 0.0;
    for (int i = 0; i <= n; ++i) {
      const double weight = i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * WithVelocity(s, from + (to - from) * i / n);
    }
    return sum * (to - from) / n / 3.0;
  }

  double variance_, a_, b_;
};

// mean = C S^-1 e, variance = s_w^2 - C S^-1 C' with C the covariance of w and the samples.
TEST(SmoothDisturbance, IsTheConditionalMeanOfTheDenseGaussian) {
  const NoiseModel model = SmoothlyDisturbed();
  const auto samples = Samples(180);
  const Eigen::Index n = 180;
  const CrossCovariance cross(model);
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(n, n);
  const auto start = [&](Eigen::Index i) { return samples[samples[i].segment == 0 ? 0 : 60].time; };
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (samples[i].segment != samples[j].segment) continue;
      const double s = samples[i].time - start(i), t = samples[j].time - start(j);
      C(i, j) = samples[j].channel == NoiseChannel::kVelocity ? cross.WithVelocity(s, t)
                                                              : cross.WithDisplacement(s, t);
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> llt(DenseCovariance(model, samples));
  const Eigen::VectorXd e = DenseDraws(model, samples, 3).Draw();
  const Eigen::VectorXd mean = C * llt.solve(e);
  const Eigen::MatrixXd explained = C * llt.solve(C.transpose());
  const SmoothedDisturbance smoothed = SmoothDisturbance(model, samples, Span(e));
  for (Eigen::Index i = 0; i < n; ++i) {
    // Simpson's error is about 1e-9 of the covariances.
    EXPECT_NEAR(smoothed.mean[i], mean[i], 1e-7) << i;
    EXPECT_NEAR(smoothed.std[i], std::sqrt(0.008 * 0.008 - explained(i, i)), 1e-7) << i;
  }
}

TEST(SmoothDisturbance, IsNothingWithoutADisturbance) {
  NoiseModel model = SmoothlyDisturbed();
  model.disturbance.std = 0.0;
  const auto samples = Samples(50);
  const Eigen::VectorXd e = Eigen::VectorXd::Ones(50);
  const SmoothedDisturbance smoothed = SmoothDisturbance(model, samples, Span(e));
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(smoothed.mean[i], 0.0);
    EXPECT_EQ(smoothed.std[i], 0.0);
  }
}

// w, v' and x' are integrated by small Euler-Maruyama steps, with no code of the library.
TEST(SmoothDisturbance, BandOf95PercentHoldsTheTruth) {
  NoiseModel model = SmoothlyDisturbed();
  model.velocity.coloured.std = model.displacement.coloured.std = 0.0;
  const double a = model.damping_rate, b = 1.0 / model.disturbance.time;
  std::mt19937 generator(21);
  std::normal_distribution<double> normal;
  double num_inside = 0.0, num_all = 0.0;
  for (int run = 0; run < 60; ++run) {
    const double h = 0.005;
    double w = 0.0, v = 0.0, x = 0.0;
    std::vector<NoiseSample> samples;
    std::vector<double> e, truth;
    // 100 s to become stationary, then 60 s at 5 Hz with a hole.
    for (int i = 0; i < 32000; ++i) {
      if (i == 20000) x = 0.0;
      const bool is_hole = i > 26000 && i < 27500;
      if (i >= 20000 && i % 40 == 0 && !is_hole) {
        samples.push_back({.time = h * i});
        e.push_back(v + model.velocity.white_std * normal(generator));
        samples.push_back({.time = h * i, .channel = NoiseChannel::kDisplacement});
        e.push_back(x + model.displacement.white_std * normal(generator));
        truth.insert(truth.end(), {w, w});
      }
      x += h * v;
      v += h * (w - a * v);
      w += -h * b * w + model.disturbance.std * std::sqrt(2.0 * b * h) * normal(generator);
    }
    const SmoothedDisturbance smoothed = SmoothDisturbance(model, samples, e);
    for (size_t i = 0; i < e.size(); ++i) {
      num_inside += std::abs(truth[i] - smoothed.mean[i]) < 1.96 * smoothed.std[i];
      num_all += 1.0;
    }
  }
  const double share = num_inside / num_all;
  std::printf("%.1f %% of the truth inside the band of 95 %%\n", 100.0 * share);
  // About 60 x 60 s / (2 x 5 s) = 360 independent times, but smoothing shortens their correlation:
  // 3 standard deviations of sqrt(0.95 x 0.05 / 360), and 0.003 for the Euler steps.
  EXPECT_NEAR(share, 0.95, 3.0 * 0.0115 + 0.003);
}

}  // namespace
}  // namespace fathom
