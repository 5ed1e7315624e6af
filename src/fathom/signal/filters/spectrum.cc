// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/spectrum.h"

#include "fathom/base/interval95.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include <glog/logging.h>
#include <unsupported/Eigen/FFT>

namespace fathom {
namespace {

// Of two Hann windows that overlap by half: (sum w_n w_{n + half})^2 / (sum w_n^2)^2.
constexpr double kSharedByNeighbours = 1.0 / 36.0;

// Periodic, so that windows half apart add up to 1.
std::vector<double> HannWindow(std::size_t size) {
  std::vector<double> weights(size);
  for (std::size_t n = 0; n < size; ++n) {
    const double turn = static_cast<double>(n) / static_cast<double>(size);
    weights[n] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * turn);
  }
  return weights;
}

// A quantile of a chi-square variable over its degrees of freedom, `z` that of the normal one
// (Wilson and Hilferty, 1931).
double ChiSquareOverFreedom(double freedom, double z) {
  const double variance = 2.0 / (9.0 * freedom);
  return std::pow(1.0 - variance + z * std::sqrt(variance), 3);
}

double MeanSquare(std::span<const std::vector<double>> residuals) {
  double squares = 0.0, count = 0.0;
  for (const std::vector<double>& residual : residuals) {
    squares = std::inner_product(residual.begin(), residual.end(), residual.begin(), squares);
    count += static_cast<double>(residual.size());
  }
  return squares / count;
}

}  // namespace

Spectrum SpectrumOf(std::span<const std::vector<double>> residuals,
                    double step,
                    std::size_t window) {
  CHECK_GT(step, 0.0);
  CHECK(window >= 4 && window % 2 == 0) << window;
  const std::vector<double> weights = HannWindow(window);
  std::vector<double> power(window / 2 - 1, 0.0);
  double num_windows = 0.0, num_neighbours = 0.0;
  Eigen::FFT<double> fft;
  std::vector<double> weighted(window);
  std::vector<std::complex<double>> transform;
  for (const std::vector<double>& residual : residuals) {
    for (std::size_t begin = 0; begin + window <= residual.size(); begin += window / 2) {
      for (std::size_t n = 0; n < window; ++n) weighted[n] = weights[n] * residual[begin + n];
      fft.fwd(transform, weighted);
      for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(transform[k + 1]);
      num_windows += 1.0;
      num_neighbours += begin > 0 ? 1.0 : 0.0;
    }
  }
  Spectrum spectrum;
  if (num_windows == 0.0) return spectrum;

  const double squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
  for (std::size_t k = 0; k < power.size(); ++k) {
    spectrum.frequency.push_back(static_cast<double>(k + 1) / (static_cast<double>(window) * step));
    spectrum.density.push_back(2.0 * step * power[k] / (num_windows * squares));
  }
  // docs/signal.md (12)
  const double freedom =
      2.0 * num_windows / (1.0 + 2.0 * kSharedByNeighbours * num_neighbours / num_windows);
  spectrum.level = 2.0 * step * MeanSquare(residuals);
  spectrum.low = spectrum.level * ChiSquareOverFreedom(freedom, -kStdsOf95);
  spectrum.high = spectrum.level * ChiSquareOverFreedom(freedom, kStdsOf95);
  return spectrum;
}

}  // namespace fathom
