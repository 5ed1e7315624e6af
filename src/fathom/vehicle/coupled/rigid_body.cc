// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/rigid_body.h"

#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/coriolis.h"

namespace fathom {
namespace {

bool IsWhollyKnown(const RigidBody& body) {
  return body.mass && body.inertia_tensor && body.centre_of_mass;
}

}  // namespace

std::optional<Matrix6> RigidInertia(const RigidBody& body) {
  if (!IsWhollyKnown(body)) return std::nullopt;
  const Eigen::Matrix3d moment = *body.mass * CrossMatrix(*body.centre_of_mass);
  Matrix6 inertia;
  inertia << *body.mass * Eigen::Matrix3d::Identity(), -moment, moment, *body.inertia_tensor;
  return inertia;
}

std::optional<Eigen::Matrix3d> InertiaAboutCentreOfMass(const RigidBody& body) {
  if (!IsWhollyKnown(body)) return std::nullopt;
  const Eigen::Matrix3d cross = CrossMatrix(*body.centre_of_mass);
  return *body.inertia_tensor + *body.mass * cross * cross;
}

bool IsPossibleInertia(const Eigen::Matrix3d& about_centre_of_mass) {
  const Eigen::Vector3d moments = EigenOf(about_centre_of_mass).values;  // the largest last
  const double rounding = 1e-9 * moments[2];
  return moments[2] > 0.0 && moments[0] >= -rounding &&
         moments[0] + moments[1] >= moments[2] - rounding;
}

}  // namespace fathom
