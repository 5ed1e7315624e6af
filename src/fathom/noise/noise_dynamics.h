// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <array>

namespace fathom {

// What happens to the state (w, v', x', c, c_x) in an interval: state <- F state + noise of
// covariance Q. docs/residual_noise.md (4) to (6). The entries of F and Q that are not named are 0,
// but for x from x, which is 1.
struct NoiseTransition {
  double w_from_w = 1.0, v_from_w = 0.0, v_from_v = 1.0, x_from_w = 0.0, x_from_v = 0.0;
  double velocity_c = 1.0, displacement_c = 1.0;
  double q_ww = 0.0, q_wv = 0.0, q_vv = 0.0, q_wx = 0.0, q_vx = 0.0, q_xx = 0.0;
  double q_velocity_c = 0.0, q_displacement_c = 0.0;
};

// The model's transitions, exact for any interval: power series of F and Q up to half a time
// constant, doubled from there. Closed forms would divide by a - 1 / tau, which may vanish.
class NoiseDynamics {
 public:
  // With `damping_factor` on the model's damping rate.
  explicit NoiseDynamics(const NoiseModel& model, double damping_factor = 1.0);

  // dt: [s], at least 0.
  NoiseTransition Over(double dt) const;

  // Stationary (co)variances of w and v'.
  double var_w() const { return var_w_; }
  double cov_wv() const { return cov_wv_; }
  double var_v() const { return var_v_; }

 private:
  static constexpr int kNumTerms = 16;

  // Coefficients of dt^k: the five entries of F, then the six of Q, in the order of
  // NoiseTransition.
  using Entries = std::array<double, 11>;

  NoiseModel model_;
  double fastest_rate_ = 0.0;
  double var_w_ = 0.0, cov_wv_ = 0.0, var_v_ = 0.0;
  std::array<Entries, kNumTerms> series_{};
};

}  // namespace fathom
