// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "dense_noise.h"

#include <cmath>

#include <Eigen/Dense>

namespace fathom {

Eigen::MatrixXd DenseCovariance(const NoiseModel& noise, std::span<const NoiseSample> samples) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  const SensorNoise& sensor = noise.velocity;
  Eigen::MatrixXd S(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const double gap = std::abs(samples[i].time - samples[j].time);
      const bool same_segment = samples[i].segment == samples[j].segment;
      S(i, j) = same_segment
                    ? std::pow(sensor.coloured.std, 2) * std::exp(-gap / sensor.coloured.time)
                    : 0.0;
    }
    S(i, i) += std::pow(sensor.white_std, 2) * samples[i].variance_factor;
  }
  return S;
}

DenseFit FitDense(const Eigen::MatrixXd& S, const Eigen::MatrixXd& X, const Eigen::VectorXd& y) {
  const Eigen::LLT<Eigen::MatrixXd> factor(S);
  const Eigen::MatrixXd weighted = factor.solve(X);
  DenseFit fit;
  fit.information = X.transpose() * weighted;
  fit.solution = fit.information.fullPivLu().solve(weighted.transpose() * y);
  const Eigen::VectorXd rest = y - X * fit.solution;
  fit.chi_squared = rest.dot(factor.solve(rest));
  return fit;
}

}  // namespace fathom
