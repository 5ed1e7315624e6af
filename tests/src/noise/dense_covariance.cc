// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "dense_covariance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

const SensorNoise& Of(const NoiseModel& model, NoiseChannel channel) {
  return channel == NoiseChannel::kVelocity ? model.velocity : model.displacement;
}

// Integral of exp(-rate |s - r|) over r from 0 to t.
double IntegralOnce(double rate, double s, double t) {
  if (s > t) return (std::exp(-rate * (s - t)) - std::exp(-rate * s)) / rate;
  return (2.0 - std::exp(-rate * s) - std::exp(-rate * (t - s))) / rate;
}

// Integral of exp(-rate |p - q|) over p from 0 to s and q from 0 to t.
double IntegralTwice(double rate, double s, double t) {
  const double rest =
      std::exp(-rate * s) + std::exp(-rate * t) - std::exp(-rate * std::abs(s - t)) - 1.0;
  return 2.0 * std::min(s, t) / rate + rest / (rate * rate);
}

// Of two samples of one segment, at s and t since its start.
double Entry(
    const NoiseModel& model, const NoiseSample& p, double s, const NoiseSample& q, double t) {
  double sum = 0.0;
  if (p.channel == q.channel) {
    const OrnsteinUhlenbeck& c = Of(model, p.channel).coloured;
    sum += c.std * c.std * std::exp(-std::abs(s - t) / c.time);
  }
  if (!model.disturbance.IsPresent()) return sum;
  const double a = model.damping_rate, b = 1.0 / model.disturbance.time;
  const double scale = std::pow(model.disturbance.std, 2) / (a * a - b * b);
  const bool p_is_v = p.channel == NoiseChannel::kVelocity;
  const bool q_is_v = q.channel == NoiseChannel::kVelocity;
  const auto of_exponential = [&](double rate) {
    if (p_is_v && q_is_v) return std::exp(-rate * std::abs(s - t));
    if (p_is_v) return IntegralOnce(rate, s, t);
    if (q_is_v) return IntegralOnce(rate, t, s);
    return IntegralTwice(rate, s, t);
  };
  return sum + scale * (of_exponential(b) - b / a * of_exponential(a));
}

}  // namespace

Eigen::MatrixXd DenseCovariance(const NoiseModel& model, std::span<const NoiseSample> samples) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd S(n, n);
  double start = 0.0;
  std::vector<double> times;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i == 0 || samples[i].segment != samples[i - 1].segment) start = samples[i].time;
    times.push_back(samples[i].time - start);
    for (Eigen::Index j = 0; j <= i; ++j) {
      S(i, j) = S(j, i) = samples[i].segment == samples[j].segment
                              ? Entry(model, samples[i], times[i], samples[j], times[j])
                              : 0.0;
    }
    S(i, i) += samples[i].variance_factor * std::pow(Of(model, samples[i].channel).white_std, 2);
  }
  return S;
}

DenseDraws::DenseDraws(const NoiseModel& model, std::span<const NoiseSample> samples, unsigned seed)
    : L_(DenseCovariance(model, samples).llt().matrixL()), generator_(seed) {}

Eigen::VectorXd DenseDraws::Draw() {
  Eigen::VectorXd white(L_.rows());
  for (double& x : white) x = normal_(generator_);
  return L_.triangularView<Eigen::Lower>() * white;
}

}  // namespace fathom
