// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/physical_barrier.h"

#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

const std::vector<Dof> kPlane = {Dof::kSurge, Dof::kSway, Dof::kYaw};

CoupledModel Boat() {
  CoupledModel model;
  model.dofs = kPlane;
  model.inertia.diagonal() << 40.0, 60.0, 0.0, 0.0, 0.0, 5.0;
  model.inertia(1, 5) = model.inertia(5, 1) = 4.0;
  model.linear_damping.diagonal() << 5.0, 8.0, 0.0, 0.0, 0.0, 2.0;
  model.linear_damping(1, 5) = 1.0;
  model.linear_damping(5, 1) = -0.4;
  model.quadratic_damping.diagonal() << 20.0, 40.0, 0.0, 0.0, 0.0, 3.0;
  model.thruster_lag = 0.3;
  return model;
}

TEST(PhysicalBarrier, HasTheGradientOfItsCost) {
  MotionStructure structure = StructureOf(StandardStructure::kFull, kPlane);
  structure.entries.push_back(ThrusterLagEntry());
  const PhysicalBarrier barrier = BarrierAt(Boat(), structure.entries, {});
  for (std::size_t k = 0; k < structure.entries.size(); ++k) {
    const FreeEntry& entry = structure.entries[k];
    const double step = 1e-5;
    CoupledModel above = Boat(), below = Boat();
    SetValue(entry, ValueIn(above, entry) + step, &above);
    SetValue(entry, ValueIn(below, entry) - step, &below);
    const double slope = (BarrierAt(above, structure.entries, {}).cost -
                          BarrierAt(below, structure.entries, {}).cost) /
                         (2.0 * step);
    EXPECT_NEAR(barrier.gradient[static_cast<Eigen::Index>(k)], slope, 1e-7) << NameOf(entry);
  }
}

TEST(PhysicalBarrier, IsInfiniteBeyondEachBound) {
  const MotionStructure structure = StructureOf(StandardStructure::kFull, kPlane);
  const auto cost = [&](const CoupledModel& model, const RigidBody& body) {
    return BarrierAt(model, structure.entries, body).cost;
  };
  EXPECT_TRUE(std::isfinite(cost(Boat(), {})));
  CoupledModel model = Boat();
  model.inertia(1, 5) = model.inertia(5, 1) = 18.0;  // its square is above 60 times 5
  EXPECT_TRUE(std::isinf(cost(model, {})));
  model = Boat();
  model.linear_damping(1, 5) = 9.0;
  EXPECT_TRUE(std::isinf(cost(model, {})));
  model = Boat();
  model.quadratic_damping(0, 0) = -1e-3;
  EXPECT_TRUE(std::isinf(cost(model, {})));
  RigidBody heavy;
  heavy.mass = 45.0;
  heavy.inertia_tensor = Eigen::Matrix3d::Identity();
  heavy.centre_of_mass = Eigen::Vector3d::Zero();
  EXPECT_TRUE(std::isinf(cost(Boat(), heavy)));  // surge has 40
}

TEST(MovedInside, BringsAModelWithinTheBounds) {
  const MotionStructure structure = StructureOf(StandardStructure::kFull, kPlane);
  CoupledModel model = Boat();
  model.inertia(1, 5) = model.inertia(5, 1) = 30.0;
  model.linear_damping(0, 0) = -3.0;
  model.quadratic_damping(5, 5) = -1.0;
  const Vector6 least = Vector6::Constant(0.1);
  const CoupledModel moved = MovedInside(model, structure.entries, {}, least, least, least);
  EXPECT_TRUE(std::isfinite(BarrierAt(moved, structure.entries, {}).cost));
  EXPECT_EQ(moved.inertia(1, 1), 60.0);
  EXPECT_EQ(moved.linear_damping(0, 0), 0.1);
}

}  // namespace
}  // namespace fathom
