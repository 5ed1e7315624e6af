// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/hydrostatics.h"

#include "generic_models.h"
#include "written_out_rate.h"
#include <Eigen/Geometry>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Weight at the centre of mass and buoyancy at its own, against g(eta) written out: (b down,
// K down_y, -K down_x, 0), the trim at rest apart.
TEST(Hydrostatics, PushesAndTurnsAsTheModel) {
  FittedCoupledModel fitted = GenericRov();
  fitted.model.righting_pitch = fitted.model.righting_roll;
  const RigidBody body = GenericTarget().vehicle->body;
  const Hydrostatics water = HydrostaticsOf(ExportModelOf(fitted, "rov.json"), body, 9.8);
  EXPECT_THAT(water.problems, IsEmpty());
  EXPECT_THAT(water.remarks, IsEmpty());
  EXPECT_NEAR(water.volume, 0.0302040816, 1e-9);
  const auto moment_at = [&](const Eigen::Vector3d& down) -> Eigen::Vector3d {
    return body.centre_of_mass->cross(water.weight * down) -
           water.centre_of_buoyancy.cross(water.buoyancy * down);
  };
  // At rest and level: the offsets of roll and pitch, on the left of the equation.
  const Eigen::Vector3d level = moment_at(Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(-level[0], fitted.model.offset[3], 1e-12);
  EXPECT_NEAR(-level[1], fitted.model.offset[4], 1e-12);
  // The moment of a tilt, K = 6 N m, beside that of the trim.
  fitted.model.offset.setZero();
  const Hydrostatics untrimmed = HydrostaticsOf(ExportModelOf(fitted, "rov.json"), body, 9.8);
  for (const DrawnState& state : DrawnStates(fitted.model, 5, true)) {
    const Eigen::Vector3d down = state.world_from_body.inverse() * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d moment = body.centre_of_mass->cross(untrimmed.weight * down) -
                                   untrimmed.centre_of_buoyancy.cross(untrimmed.buoyancy * down);
    const Eigen::Vector3d truth(-6.0 * down.y(), 6.0 * down.x(), 0.0);
    EXPECT_LT((moment - truth).norm(), 1e-12);
  }
}

// The model rests at asin(5/60), one righting moment of 33 N m for both at atan(5/33).
TEST(Hydrostatics, FailsWhereTheTrimAtRestWouldBeAnother) {
  FittedCoupledModel fitted = GenericRov();
  fitted.model.righting_pitch = 60.0;
  fitted.model.offset[4] = -5.0;
  EXPECT_THAT(HydrostaticsOf(ExportModelOf(fitted, "rov.json"), GenericTarget().vehicle->body, 9.8)
                  .problems,
              ElementsAre(HasSubstr("a pitch of 8.62 degrees, the model has 4.78")));
}

TEST(Hydrostatics, FailsOfABuoyancyBelow0) {
  FittedCoupledModel fitted = GenericRov();
  fitted.model.net_buoyancy = -300.0;
  EXPECT_THAT(HydrostaticsOf(ExportModelOf(fitted, "rov.json"), GenericTarget().vehicle->body, 9.8)
                  .problems,
              ElementsAre(HasSubstr("The buoyancy would be -6 N")));
}

}  // namespace
}  // namespace fathom
