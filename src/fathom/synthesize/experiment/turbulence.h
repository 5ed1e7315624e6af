// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/random_stream.h"

#include <vector>

namespace fathom {

// How rough the water is along one DOF.
struct TurbulenceSpec {
  double force = 0.0;             // standard deviation [N] or [N m]; 0: still
  double correlation_time = 1.0;  // [s], above 0
};

// A random force on the vehicle: stationary, normal, with correlation exp(-|s| / T) over s seconds
// (Ornstein and Uhlenbeck).
//
//   x_0 = e_0,   x_k = a x_{k-1} + sqrt(1 - a^2) e_k,   a = exp(-h / T)   docs/synthesize.md (8)
//
// Exact on a grid of h = T / 50 and straight in between, which takes at most 0.7 % of the variance.
class Turbulence {
 public:
  static constexpr int kStepsPerCorrelationTime = 50;

  Turbulence() = default;  // none

  // From t = 0 to `duration` [s].
  Turbulence(const TurbulenceSpec& spec, double duration, RandomStream random);

  bool empty() const { return force_.empty(); }

  // [N] or [N m], at t in [0, duration].
  double At(double t) const;

 private:
  double step_ = 1.0;
  std::vector<double> force_;
};

}  // namespace fathom
