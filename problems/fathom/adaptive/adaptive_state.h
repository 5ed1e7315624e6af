// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

namespace fathom {

// All that the adaptive law knows between two samples, beside its gains: what AdaptiveIdentifier
// goes on from, to the last digit.
struct AdaptiveState {
  double estimated_velocity = 0.0;    // v_hat [m/s] or [rad/s]
  std::array<double, 4> lumped = {};  // Phi: alpha, beta, mu, nu
  double t = 0.0;                     // of the last sample [s]
  double force = 0.0;                 // of the last sample [N] or [N m]
  double velocity = 0.0;              // measured, of the last sample [m/s] or [rad/s]
  long num_samples = 0;               // at least 0
  bool segment_started = false;       // whether the next sample goes on from the last one
};

}  // namespace fathom
