// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace fathom {

// One degree of freedom of a vehicle in still water, the others held.
//
//   m dv/dt + d_Q v|v| + d_L v + b = tau                     docs/models.md (1)
//
//   v    speed along the DOF                                 [m/s] or [rad/s]
//   tau  generalised force                                   [N] or [N m]
//   m    inertia: body plus added mass, above 0              [kg] or [kg m^2]
//   d_Q  quadratic damping, at least 0                       [kg/m] or [kg m^2]
//   d_L  linear damping, at least 0                          [kg/s] or [kg m^2/s]
//   b    buoyancy or thrust offset                           [N] or [N m]
//
// A wrong unit of tau scales all four parameters alike: they are known only as far as the thrust
// is.
//
// T is double, or a differentiated scalar while fitting.
template <typename T>
struct UncoupledModel {
  T inertia{1.0};
  T quadratic_damping{0.0};
  T linear_damping{0.0};
  T buoyancy{0.0};

  // Equation (1) solved for dv/dt [m/s^2] or [rad/s^2]. The force may be a plain number while the
  // parameters are differentiated.
  template <typename Force>
  [[gnu::always_inline]] T Acceleration(const T& speed, const Force& force) const {
    using std::abs;
    const T damping = (quadratic_damping * abs(speed) + linear_damping) * speed;
    return (force - damping - buoyancy) / inertia;
  }

  // Slope of the damping force over the speed [kg/s] or [kg m^2/s].
  T DampingSlope(const T& speed) const {
    using std::abs;
    return linear_damping + 2.0 * quadratic_damping * abs(speed);
  }
};

}  // namespace fathom
