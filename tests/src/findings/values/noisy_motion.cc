// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "values/noisy_motion.h"

#include <cmath>
#include <numbers>
#include <random>

namespace fathom {

NoisyMotion NoisyMotionOf(int num_rows, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0.0, 0.02);
  NoisyMotion motion;
  for (int row = 0; row < num_rows; ++row) {
    motion.time.push_back(0.1 * row);
    motion.value.push_back(0.5 * std::sin(2.0 * std::numbers::pi * 0.1 * row / 20.0) +
                           noise(generator));
  }
  return motion;
}

std::vector<double> Rounded(std::vector<double> values, double resolution) {
  for (double& value : values) value = resolution * std::round(value / resolution);
  return values;
}

}  // namespace fathom
