// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Noise whose autocorrelation and spectrum are known.

#pragma once

#include <cmath>
#include <random>
#include <vector>

namespace fathom {

// x_i = a x_{i-1} + n_i, n_i of standard deviation `sigma`; from its stationary spread on.
inline std::vector<double> FirstOrderNoise(int size,
                                           double a,
                                           double sigma,
                                           std::mt19937* generator) {
  std::normal_distribution<double> normal(0.0, sigma);
  std::vector<double> x = {normal(*generator) / std::sqrt(1.0 - a * a)};
  while (static_cast<int>(x.size()) < size) x.push_back(a * x.back() + normal(*generator));
  return x;
}

inline std::vector<double> WhiteNoise(int size, double sigma, std::mt19937* generator) {
  return FirstOrderNoise(size, 0.0, sigma, generator);
}

}  // namespace fathom
