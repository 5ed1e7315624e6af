// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/rigid_body.h"

#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

struct PointMass {
  double mass;
  Eigen::Vector3d at;
};

const std::vector<PointMass> kPoints = {
    {2.0, {0.3, 0.1, -0.2}}, {1.5, {-0.4, 0.2, 0.1}}, {3.0, {0.1, -0.3, 0.25}}};

RigidBody BodyOfPoints() {
  RigidBody body;
  body.mass = 0.0;
  body.centre_of_mass = Eigen::Vector3d::Zero();
  body.inertia_tensor = Eigen::Matrix3d::Zero();
  for (const auto& [mass, at] : kPoints) {
    *body.mass += mass;
    *body.centre_of_mass += mass * at;
    *body.inertia_tensor +=
        mass * (at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose());
  }
  *body.centre_of_mass /= *body.mass;
  return body;
}

// Twice the kinetic energy is nu' M nu: of the body, and of its points one by one.
TEST(RigidInertia, HasTheEnergyOfItsPoints) {
  const Vector6 nu(0.7, -0.3, 0.2, 0.4, -0.6, 0.5);
  double energy = 0.0;
  for (const auto& [mass, at] : kPoints) {
    energy += mass * (nu.head<3>() + nu.tail<3>().cross(at)).squaredNorm();
  }
  const auto inertia = RigidInertia(BodyOfPoints());
  ASSERT_TRUE(inertia);
  EXPECT_NEAR(nu.dot(*inertia * nu), energy, 1e-12);
  EXPECT_LT((*inertia - inertia->transpose()).norm(), 1e-12);
}

TEST(RigidInertia, IsUnknownWhereAPartIs) {
  RigidBody body = BodyOfPoints();
  body.centre_of_mass.reset();
  EXPECT_FALSE(RigidInertia(body));
  EXPECT_FALSE(InertiaAboutCentreOfMass(body));
}

TEST(InertiaAboutCentreOfMass, IsThatOfThePointsAboutIt) {
  const RigidBody body = BodyOfPoints();
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (const auto& [mass, at] : kPoints) {
    const Eigen::Vector3d from = at - *body.centre_of_mass;
    expected += mass * (from.squaredNorm() * Eigen::Matrix3d::Identity() - from * from.transpose());
  }
  const auto about = InertiaAboutCentreOfMass(body);
  ASSERT_TRUE(about);
  EXPECT_LT((*about - expected).norm(), 1e-12);
  EXPECT_TRUE(IsPossibleInertia(*about));
}

// No body has one moment above the sum of the others.
TEST(IsPossibleInertia, KeepsTheTriangle) {
  EXPECT_TRUE(IsPossibleInertia(Eigen::Vector3d(1.0, 2.0, 2.9).asDiagonal()));
  EXPECT_FALSE(IsPossibleInertia(Eigen::Vector3d(1.0, 2.0, 3.1).asDiagonal()));
  EXPECT_FALSE(IsPossibleInertia(Eigen::Vector3d(-0.1, 2.0, 2.0).asDiagonal()));
}

}  // namespace
}  // namespace fathom
