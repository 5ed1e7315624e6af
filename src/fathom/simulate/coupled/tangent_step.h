// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/six_vector.h"

#include <span>

#include <Eigen/Core>

namespace fathom {

// What a state depends on. Rows: the velocities by Index(Dof), a small turn in the body frame
// [rad], the position in the world [m]. Columns: as those of CoupledOutputs.
using CoupledTangent = Eigen::Matrix<double, 12, Eigen::Dynamic>;

// How the rate of a tangent follows from it at a state, docs/coupled.md (5):
//
//   M s' = force (s, s_turn) + f,   s_turn' = s_omega + turn s_turn,   x' = position (s, s_turn)
//
//   f  what an entry does to the forces
struct TangentLaw {
  Eigen::Matrix<double, 6, 9> force;
  Eigen::Matrix3d turn;
  Eigen::Matrix<double, 3, 9> position;
};

// One step of the classical Runge-Kutta scheme for tangents. The law is linear in them, so what the
// step does is worked out once for all columns.
struct TangentStep {
  Eigen::Matrix<double, 12, 9> by_tangent;   // beside that the position stays
  Eigen::Matrix<double, 12, 6> by_force[4];  // of f at each stage

  // Laws at the four stages of a step of `h` [s]; `inverse` of M, 0 where not modelled.
  void Set(std::span<const TangentLaw, 4> laws, const Matrix6& inverse, double h);
};

}  // namespace fathom
