// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/six_vector.h"

namespace fathom {

// The Coriolis and centripetal forces of a symmetric inertia M at a velocity nu = (v, omega), about
// the body's origin, for rigid body and added mass alike:
//
//   C(nu) nu = (omega x pi_1,  v x pi_1 + omega x pi_2),   pi = M nu        docs/coupled.md (2)
//
//   pi_1  linear momentum                                     [kg m/s]
//   pi_2  angular momentum                                    [kg m^2/s]
//
// They do no work: nu' C(nu) nu = 0. Still, unbounded water; Fossen 2021, Theorem 6.2.

// The forces of a momentum pi at nu: linear in pi.
[[gnu::always_inline]] inline Vector6 CoriolisForceOfMomentum(const Vector6& momentum,
                                                              const Vector6& nu) {
  const double u = nu[0], v = nu[1], w = nu[2], p = nu[3], q = nu[4], r = nu[5];
  const double x = momentum[0], y = momentum[1], z = momentum[2];
  const double k = momentum[3], m = momentum[4], n = momentum[5];
  Vector6 force;
  force << q * z - r * y, r * x - p * z, p * y - q * x,  //
      v * z - w * y + q * n - r * m,                     //
      w * x - u * z + r * k - p * n,                     //
      u * y - v * x + p * m - q * k;
  return force;
}

inline Vector6 CoriolisForce(const Matrix6& inertia, const Vector6& nu) {
  return CoriolisForceOfMomentum(inertia * nu, nu);
}

// S(x) y = x x y.
inline Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& x) {
  Eigen::Matrix3d s;
  s << 0.0, -x[2], x[1], x[2], 0.0, -x[0], -x[1], x[0], 0.0;
  return s;
}

// The skew-symmetric C(nu) itself, ((0, -S(pi_1)), (-S(pi_1), -S(pi_2))).
inline Matrix6 CoriolisMatrix(const Matrix6& inertia, const Vector6& nu) {
  const Vector6 momentum = inertia * nu;
  Matrix6 c = Matrix6::Zero();
  c.topRightCorner<3, 3>() = -CrossMatrix(momentum.head<3>());
  c.bottomLeftCorner<3, 3>() = c.topRightCorner<3, 3>();
  c.bottomRightCorner<3, 3>() = -CrossMatrix(momentum.tail<3>());
  return c;
}

// The derivative of C(nu) nu by nu: C(nu), and what nu does to the momentum.
inline Matrix6 CoriolisJacobian(const Matrix6& inertia, const Vector6& nu) {
  const Eigen::Matrix3d by_v = CrossMatrix(nu.head<3>());
  const Eigen::Matrix3d by_omega = CrossMatrix(nu.tail<3>());
  Matrix6 jacobian = CoriolisMatrix(inertia, nu);
  jacobian.topRows<3>() += by_omega * inertia.topRows<3>();
  jacobian.bottomRows<3>() += by_v * inertia.topRows<3>() + by_omega * inertia.bottomRows<3>();
  return jacobian;
}

}  // namespace fathom
