// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace fathom {

// The covariance of the noise written out by integrals of the autocovariance of v', with no state
// space in it. With b = 1 / tau, the spectrum 2 b s_w^2 / ((w^2 + b^2) (w^2 + a^2)) transforms to
//
//   R(s) = s_w^2 / (a^2 - b^2) (exp(-b |s|) - b / a exp(-a |s|)),   a and b different,
//
// and x'(t) is the integral of v' from the start of the segment.
class DenseCovariance {
 public:
  explicit DenseCovariance(const NoiseModel& model) : model_(model) {}

  Eigen::MatrixXd Of(std::span<const NoiseSample> samples) const {
    const auto n = static_cast<Eigen::Index>(samples.size());
    Eigen::MatrixXd S(n, n);
    double start = 0.0;
    std::vector<double> times;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (i == 0 || samples[i].segment != samples[i - 1].segment) start = samples[i].time;
      times.push_back(samples[i].time - start);
      for (Eigen::Index j = 0; j <= i; ++j) {
        S(i, j) = S(j, i) = samples[i].segment == samples[j].segment
                                ? Entry(samples[i], times[i], samples[j], times[j])
                                : 0.0;
      }
      S(i, i) += samples[i].variance_factor * std::pow(Of(samples[i].channel).white_std, 2);
    }
    return S;
  }

 private:
  const SensorNoise& Of(NoiseChannel channel) const {
    return channel == NoiseChannel::kVelocity ? model_.velocity : model_.displacement;
  }

  double Entry(const NoiseSample& p, double s, const NoiseSample& q, double t) const {
    double sum = 0.0;
    if (p.channel == q.channel) {
      const OrnsteinUhlenbeck& c = Of(p.channel).coloured;
      sum += c.std * c.std * std::exp(-std::abs(s - t) / c.time);
    }
    if (!model_.disturbance.IsPresent()) return sum;
    const double a = model_.damping_rate, b = 1.0 / model_.disturbance.time;
    const double scale = std::pow(model_.disturbance.std, 2) / (a * a - b * b);
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

  // Integral of exp(-rate |s - r|) over r from 0 to t.
  static double IntegralOnce(double rate, double s, double t) {
    if (s > t) return (std::exp(-rate * (s - t)) - std::exp(-rate * s)) / rate;
    return (2.0 - std::exp(-rate * s) - std::exp(-rate * (t - s))) / rate;
  }

  // Integral of exp(-rate |p - q|) over p from 0 to s and q from 0 to t.
  static double IntegralTwice(double rate, double s, double t) {
    const double rest =
        std::exp(-rate * s) + std::exp(-rate * t) - std::exp(-rate * std::abs(s - t)) - 1.0;
    return 2.0 * std::min(s, t) / rate + rest / (rate * rate);
  }

  NoiseModel model_;
};

// Draws of the noise by the Cholesky factor of its dense covariance.
class DenseDraws {
 public:
  DenseDraws(const NoiseModel& model, std::span<const NoiseSample> samples, unsigned seed)
      : L_(DenseCovariance(model).Of(samples).llt().matrixL()), generator_(seed) {}

  Eigen::VectorXd Draw() {
    Eigen::VectorXd white(L_.rows());
    for (double& x : white) x = normal_(generator_);
    return L_.triangularView<Eigen::Lower>() * white;
  }

 private:
  Eigen::MatrixXd L_;
  std::mt19937 generator_;
  std::normal_distribution<double> normal_;
};

inline std::span<const double> Span(const Eigen::VectorXd& x) {
  return {x.data(), static_cast<size_t>(x.size())};
}

// Velocity samples every `step` over `duration`, but for those that `is_missing` names by index.
template <typename Predicate>
std::vector<NoiseSample> VelocitySamples(double duration,
                                         double step,
                                         const Predicate& is_missing) {
  std::vector<NoiseSample> samples;
  for (int i = 0; i * step < duration; ++i) {
    if (!is_missing(i)) samples.push_back({.time = i * step});
  }
  return samples;
}

inline std::vector<NoiseSample> VelocitySamples(double duration, double step) {
  return VelocitySamples(duration, step, [](int) { return false; });
}

}  // namespace fathom
