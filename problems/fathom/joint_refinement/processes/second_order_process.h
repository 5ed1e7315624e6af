// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace fathom {

// What a coordinate does between one frame and a later one, by itself:
//
//   s(t + h) = Phi s(t) + e,   e ~ N(0, Q),   s = (n, dn/dt)
struct Transition {
  Eigen::Matrix2d Phi;
  Eigen::Matrix2d Q;         // positive definite
  Eigen::Matrix2d whitener;  // lower triangular W with W Q W' = I
  double log_det_Q = 0.0;
};

// Gauss-Markov motion of one coordinate about where it is expected: a mass on a spring and a
// damper, pushed by white noise. docs/joint_refinement.md (4), (5)
//
//   n'' + damping n' + stiffness n = w,   E w(t) w(t + h) = intensity delta(h)
//
//   n          deviation                  [m] or [rad]
//   damping    of the vehicle and its controller, above 0          [1/s]
//   stiffness  of the controller, at least 0; 0: nothing brings it back  [1/s^2]
//   intensity  of the push, above 0       [m^2/s^3] or [rad^2/s^3]
//
// Strongly damped it is an Ornstein-Uhlenbeck process, critically damped a Matern process of order
// 3/2, weakly damped the hunting of a controller, without stiffness the position of a vehicle under
// random force.
struct SecondOrderProcess {
  double stiffness = 1.0;
  double damping = 2.0;
  double intensity = 0.0;

  // A stationary process by its standard deviation, natural frequency [rad/s] and damping ratio.
  static SecondOrderProcess Held(double std, double frequency, double ratio);

  bool IsPresent() const { return intensity > 0.0; }

  // Covariance of (n, dn/dt) at any time; the stiffness is above 0.
  Eigen::Matrix2d StationaryCovariance() const;

  // Over a time `h` [s], above 0.
  Transition Over(double h) const;
};

}  // namespace fathom
