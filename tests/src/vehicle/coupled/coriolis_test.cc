// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/coriolis.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Any symmetric positive definite matrix.
Matrix6 FullInertia() {
  Matrix6 root;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) root(i, j) = std::sin(1.0 + 5.0 * i + 3.0 * j);
  }
  return root * root.transpose() + Matrix6::Identity();
}

Vector6 SomeVelocity() { return Vector6(0.7, -0.3, 0.2, 0.4, -0.6, 0.5); }

TEST(Coriolis, DoesNoWork) {
  const Vector6 nu = SomeVelocity();
  EXPECT_NEAR(nu.dot(CoriolisForce(FullInertia(), nu)), 0.0, 1e-12);
}

TEST(Coriolis, IsASkewMatrixTimesTheVelocity) {
  const Vector6 nu = SomeVelocity();
  const Matrix6 c = CoriolisMatrix(FullInertia(), nu);
  EXPECT_LT((c + c.transpose()).norm(), 1e-12);
  EXPECT_LT((c * nu - CoriolisForce(FullInertia(), nu)).norm(), 1e-12);
}

// In the horizontal plane with a diagonal inertia: -M22 v r, M11 u r and the Munk moment
// (M22 - M11) u v; Fossen 2021, Eq. 6.98.
TEST(Coriolis, IsThatOfTextbooksInThePlane) {
  Matrix6 inertia = Matrix6::Zero();
  inertia.diagonal() << 48.0, 81.0, 90.0, 5.0, 6.0, 16.0;
  Vector6 nu = Vector6::Zero();
  nu[0] = 0.7, nu[1] = -0.3, nu[5] = 0.5;
  const Vector6 force = CoriolisForce(inertia, nu);
  EXPECT_NEAR(force[0], -81.0 * -0.3 * 0.5, 1e-12);
  EXPECT_NEAR(force[1], 48.0 * 0.7 * 0.5, 1e-12);
  EXPECT_NEAR(force[5], (81.0 - 48.0) * 0.7 * -0.3, 1e-12);
}

TEST(Coriolis, HasTheDerivativeOfDifferences) {
  const Matrix6 inertia = FullInertia();
  const Vector6 nu = SomeVelocity();
  const Matrix6 jacobian = CoriolisJacobian(inertia, nu);
  for (int k = 0; k < 6; ++k) {
    constexpr double kStep = 1e-6;
    const Vector6 step = kStep * Vector6::Unit(k);
    const Vector6 difference =
        (CoriolisForce(inertia, nu + step) - CoriolisForce(inertia, nu - step)) / (2.0 * kStep);
    EXPECT_LT((jacobian.col(k) - difference).norm(), 1e-7) << k;
  }
}

}  // namespace
}  // namespace fathom
