// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/export_checks.h"

#include "generic_models.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(CheckExport, FindsNothingInVehiclesThatSlowDown) {
  EXPECT_THAT(CheckExport(GenericRov().model), IsEmpty());
  EXPECT_THAT(CheckExport(GenericBoat().model), IsEmpty());
}

// Quadratic damping alone: v = v0/(1 + 5) after five of its time constants, so 1/36 of the energy.
TEST(CheckExport, TakesQuadraticDampingAlone) {
  CoupledModel model;
  model.dofs = {Dof::kSurge};
  model.inertia(0, 0) = 40.0;
  model.quadratic_damping(0, 0) = 30.0;
  EXPECT_THAT(CheckExport(model), IsEmpty());
}

// 55 x 7.3 - 21^2 < 0: its smaller eigenvalue is (62.3 - sqrt(47.7^2 + 4 x 21^2))/2 = -0.628.
TEST(CheckExport, RefusesAnInertiaWithANegativeEigenvalue) {
  CoupledModel model = GenericBoat().model;
  model.dofs = {Dof::kSurge, Dof::kYaw};
  model.inertia(0, 5) = model.inertia(5, 0) = 21.0;
  EXPECT_THAT(CheckExport(model), ElementsAre(HasSubstr("eigenvalue of -0.6")));
}

TEST(CheckExport, RefusesDampingThatDrives) {
  CoupledModel model = GenericBoat().model;
  model.linear_damping(1, 5) = 90.0;
  model.linear_damping(5, 1) = 90.0;
  EXPECT_THAT(CheckExport(model), Not(IsEmpty()));
  EXPECT_THAT(CheckExport(model).front(), HasSubstr("A free decay from 0.5"));
}

// Both eigenvalues of D are above 0, but those of its symmetric part are not: a turn gives the sway
// (60 x 0.5/80 m/s^2 for about a second) more energy than it had itself.
TEST(CheckExport, RefusesDampingThatDrivesForAWhile) {
  CoupledModel model;
  model.dofs = {Dof::kSway, Dof::kYaw};
  model.inertia(1, 1) = 80.0;
  model.inertia(5, 5) = 7.0;
  model.linear_damping(1, 1) = 20.0;
  model.linear_damping(5, 5) = 3.0;
  model.linear_damping(1, 5) = 60.0;
  EXPECT_THAT(CheckExport(model), ElementsAre(HasSubstr("0.5 rad/s of yaw gains energy at")));
}

TEST(CheckExport, RefusesADofWithoutDamping) {
  CoupledModel model = GenericBoat().model;
  model.linear_damping(0, 0) = model.quadratic_damping(0, 0) = 0.0;
  EXPECT_THAT(CheckExport(model), ElementsAre(HasSubstr("no damping")));
}

// Passive below 5 m/s, where a decay is let go: b = 20 N drive it beyond.
TEST(CheckExport, RefusesASinkThatDampingDrives) {
  CoupledModel model;
  model.dofs = {Dof::kHeave};
  model.inertia(2, 2) = 40.0;
  model.linear_damping(2, 2) = 5.0;
  model.quadratic_damping(2, 2) = -1.0;
  EXPECT_THAT(CheckExport(model), IsEmpty());
  model.net_buoyancy = 20.0;
  EXPECT_THAT(
      CheckExport(model),
      ElementsAre(HasSubstr("A free sink from rest, under the net buoyancy of 20 N, diverges")));
  model.quadratic_damping(2, 2) = 1.0;
  EXPECT_THAT(CheckExport(model), IsEmpty());
}

TEST(CheckExport, RefusesAVehicleThatTurnsOverAtRest) {
  CoupledModel model = GenericRov().model;
  model.righting_roll = -1.0;
  model.offset[4] = 7.5;
  EXPECT_THAT(CheckExport(model),
              ElementsAre(HasSubstr("The righting moment of roll is -1 N m"),
                          HasSubstr("The offset of pitch is 7.5 N m, above its righting moment of "
                                    "7 N m")));
}

}  // namespace
}  // namespace fathom
