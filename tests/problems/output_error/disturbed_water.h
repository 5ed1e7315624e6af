// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <random>

namespace fathom {

// A random force of the water on a vehicle: stationary, of mean 0, drawn by codes of their own.
struct WaterForce {
  enum class Kind {
    kStill,
    kTurbulence,  // Ornstein-Uhlenbeck, `time` its correlation time: as the learned noise assumes
    kWander,      // normal, flat between 0.01 and 0.25 Hz, nothing beyond
    kSteps,       // held for times of mean `time`, exponentially distributed; levels are normal
    kGusts,       // half sines of `time` that come at random, one in 4 `time`, either way
  };
  Kind kind = Kind::kStill;
  double std = 0.0;   // [N]
  double time = 1.0;  // [s]

  // Covariance of the forces `lag` seconds apart [N^2], in closed form.
  double Covariance(double lag) const;

  // A realisation over `duration` seconds, from 0.
  std::function<double(double)> Draw(double duration, std::mt19937& generator) const;
};

}  // namespace fathom
