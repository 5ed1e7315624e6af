// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/stamp_noise.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fathom {
namespace {

constexpr std::size_t kLongestEcho = 100000;  // [samples]
constexpr double kSilence = 1e-9;             // of an echo against the first
constexpr std::size_t kHighestOrder = 20;

}  // namespace

std::vector<double> CorrelationsOf(std::span<const double> coefficients, int count) {
  // How one innovation echoes.
  std::vector<double> echo = {1.0};
  double loudest_lately = 1.0;
  const std::size_t order = coefficients.size();
  while (loudest_lately > kSilence) {
    if (echo.size() > kLongestEcho) {
      throw InputError(
          "'fit.residual_autoregression' is not stable, expected coefficients of noise that dies "
          "away.");
    }
    double value = 0.0;
    for (std::size_t k = 0; k < std::min(order, echo.size()); ++k) {
      value += coefficients[k] * echo[echo.size() - 1 - k];
    }
    echo.push_back(value);
    loudest_lately = 0.0;
    for (std::size_t k = 0; k < std::min(std::max<std::size_t>(1, order), echo.size()); ++k) {
      loudest_lately = std::max(loudest_lately, std::abs(echo[echo.size() - 1 - k]));
    }
  }
  std::vector<double> correlations(static_cast<std::size_t>(count), 0.0);
  for (std::size_t lag = 0; lag < correlations.size(); ++lag) {
    for (std::size_t i = 0; i + lag < echo.size(); ++i) {
      correlations[lag] += echo[i] * echo[i + lag];
    }
  }
  for (std::size_t lag = correlations.size(); lag-- > 0;) correlations[lag] /= correlations[0];
  return correlations;
}

std::vector<double> PlainestColour(std::span<const double> coefficients, int num_samples) {
  const int order = static_cast<int>(coefficients.size());
  const std::vector<double> correlations = CorrelationsOf(coefficients, order + 1);
  std::vector<double> plainest;
  double least = 0.0;  // of white noise
  for (int k = 1; k <= order; ++k) {
    const Autoregression shorter =
        AutoregressionOf(std::span(correlations).first(static_cast<std::size_t>(k) + 1));
    const double bic =
        num_samples * std::log(shorter.innovation_variance) + k * std::log(num_samples);
    if (bic >= least) continue;
    least = bic;
    plainest = shorter.coefficients;
  }
  return plainest;
}

StampNoise MeansOf(double velocity, std::span<const double> coefficients, int num_samples) {
  const std::size_t order = std::min(kHighestOrder, coefficients.size());
  const auto r = static_cast<std::size_t>(num_samples);
  const std::vector<double> samples =
      CorrelationsOf(coefficients, static_cast<int>((order + 1) * r));
  // Of two means k stamps apart: over all pairs of their samples.
  std::vector<double> means(order + 1, 0.0);
  for (std::size_t k = 0; k <= order; ++k) {
    for (std::size_t i = 0; i < r; ++i) {
      for (std::size_t j = 0; j < r; ++j) {
        const std::size_t apart = k * r + i;
        means[k] += samples[apart > j ? apart - j : j - apart];
      }
    }
    means[k] /= static_cast<double>(r * r);
  }
  StampNoise noise;
  noise.velocity = velocity * std::sqrt(means[0]);
  for (std::size_t k = order + 1; k-- > 0;) means[k] /= means[0];
  noise.colour = AutoregressionOf(means);
  return noise;
}

}  // namespace fathom
