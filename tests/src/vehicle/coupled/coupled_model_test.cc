// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/coupled_model.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(IsPositiveDefinite, AsksForTheModelledPartAlone) {
  Matrix6 inertia = Matrix6::Zero();
  inertia(0, 0) = 40.0, inertia(1, 1) = 50.0, inertia(5, 5) = 4.0;
  inertia(1, 5) = inertia(5, 1) = 14.0;  // 14^2 < 50 * 4
  EXPECT_TRUE(IsPositiveDefinite(inertia, {Dof::kSurge, Dof::kSway, Dof::kYaw}));
  EXPECT_FALSE(IsPositiveDefinite(inertia, {Dof::kSurge, Dof::kHeave}));
  inertia(1, 5) = inertia(5, 1) = 14.2;
  EXPECT_FALSE(IsPositiveDefinite(inertia, {Dof::kSurge, Dof::kSway, Dof::kYaw}));
}

// The symmetric part counts: 10 and -6 off the diagonal take what 2 and -2 take.
TEST(IsPassive, AsksForTheSymmetricPart) {
  CoupledModel model;
  model.dofs = {Dof::kSway, Dof::kYaw};
  model.linear_damping(1, 1) = 4.0, model.linear_damping(5, 5) = 1.0;
  model.linear_damping(1, 5) = 10.0, model.linear_damping(5, 1) = -6.0;
  EXPECT_TRUE(IsPassive(model));
  model.linear_damping(5, 1) = -5.9;
  EXPECT_FALSE(IsPassive(model));
  model.linear_damping(5, 1) = -6.0;
  model.quadratic_damping(5, 5) = -0.1;
  EXPECT_FALSE(IsPassive(model));
}

}  // namespace
}  // namespace fathom
