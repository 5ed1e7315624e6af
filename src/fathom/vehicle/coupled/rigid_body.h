// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/six_vector.h"

#include <optional>

#include <Eigen/Core>

namespace fathom {

// What is known of a vehicle's body without its water: body frame, about the body's origin.
struct RigidBody {
  std::optional<double> mass;  // dry [kg], above 0

  // About the body's origin, Fossen's I_b [kg m^2]: symmetric, with -int x y dm off the diagonal.
  // About the centre of mass r_g it would be I_b + m S(r_g)^2.
  std::optional<Eigen::Matrix3d> inertia_tensor;

  std::optional<Eigen::Vector3d> centre_of_mass;      // r_g [m]
  std::optional<double> volume;                       // of the displaced water [m^3], above 0
  std::optional<Eigen::Vector3d> centre_of_buoyancy;  // r_b [m]
};

// The inertia of the body alone.
//
//   M_rigid = ((m I, -m S(r_g)), (m S(r_g), I_b))             docs/coupled.md (3)
//
// Nothing unless mass, inertia tensor and centre of mass are known. Fossen 2021, Eq. 3.49.
std::optional<Matrix6> RigidInertia(const RigidBody& body);

// I_b + m S(r_g)^2, the tensor about the centre of mass [kg m^2]; nothing unless all is known.
std::optional<Eigen::Matrix3d> InertiaAboutCentreOfMass(const RigidBody& body);

// Whether some distribution of mass has this tensor about its centre of mass: principal moments at
// least 0, and none above the sum of the others.
bool IsPossibleInertia(const Eigen::Matrix3d& about_centre_of_mass);

}  // namespace fathom
