// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What keeps a search among models that can be: a cost that grows without bound towards an inertia
// (less the body's own, where that is known) or a linear damping that is not positive definite, and
// towards a quadratic damping below 0.
//
//   -mu (log det(M - M_rigid) + log det((D_L + D_L')/2) + sum log D_Q,ii)     docs/coupled.md (7)
//
// mu is so small, 0.05 of what half a standard deviation squared is, that a number which the data
// hold well away from its bound does not move; one that they push against it ends just above.
struct PhysicalBarrier {
  // Infinite where a bound is broken.
  double cost = 0.0;
  Eigen::VectorXd gradient;  // by the entries
  Eigen::MatrixXd hessian;
};

// M_rigid: what the body alone has of the inertia. Its dry mass along the axes where no more is
// known, 0 of nothing.
Matrix6 KnownInertia(const RigidBody& body);

PhysicalBarrier BarrierAt(const CoupledModel& model,
                          std::span<const FreeEntry> entries,
                          const RigidBody& body);

// The model itself where it is inside all bounds; else the nearest along the way to one without
// couplings whose bounds hold. `scale`: the least linear and quadratic damping of a DOF.
CoupledModel MovedInside(CoupledModel model,
                         std::span<const FreeEntry> entries,
                         const RigidBody& body,
                         const Vector6& least_linear,
                         const Vector6& least_quadratic,
                         const Vector6& least_inertia);

}  // namespace fathom
