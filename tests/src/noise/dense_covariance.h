// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <random>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The covariance of the noise written out by integrals of the autocovariance of v', with no state
// space in it. With b = 1 / tau, the spectrum 2 b s_w^2 / ((w^2 + b^2) (w^2 + a^2)) transforms to
//
//   R(s) = s_w^2 / (a^2 - b^2) (exp(-b |s|) - b / a exp(-a |s|)),   a and b different,
//
// and x'(t) is the integral of v' from the start of the segment.
Eigen::MatrixXd DenseCovariance(const NoiseModel& model, std::span<const NoiseSample> samples);

// Draws of the noise by its Cholesky factor.
class DenseDraws {
 public:
  DenseDraws(const NoiseModel& model, std::span<const NoiseSample> samples, unsigned seed);

  Eigen::VectorXd Draw();

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
