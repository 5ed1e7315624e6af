// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <span>
#include <vector>

namespace fathom {

// The acceleration that the simulation misses, as a function of time: mean and standard deviation
// of w at each sample's time, given the whole residual. docs/residual_noise.md (10).
struct SmoothedDisturbance {
  std::vector<double> mean;  // [m/s^2] or [rad/s^2]
  std::vector<double> std;   // [m/s^2] or [rad/s^2]
};

SmoothedDisturbance SmoothDisturbance(const NoiseModel& model,
                                      std::span<const NoiseSample> samples,
                                      std::span<const double> residual);

}  // namespace fathom
