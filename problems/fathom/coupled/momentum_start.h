// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/motion_structure.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <span>

namespace fathom {

// A first guess by least squares: docs/coupled.md (1) for all DOFs at once, which is the paper's
// Eq. 6 with couplings, integrated over pieces of a second so that no acceleration is needed.
//
//   M (nu_b - nu_a) + int (C nu + D nu + g + o - B T) dt = 0       docs/coupled.md (6)
//
// It is linear in the entries but for bounds: one that `held` leaves infinite starts at the value
// of LimitsTried() that brings (6) nearest, one that it holds starts there. Entries that these data
// cannot tell stay small. The result is inside the bounds of PhysicalBarrier. `held`: the numbers
// that are not free.
CoupledModel MomentumStart(std::span<const CoupledData> logs,
                           const MotionStructure& structure,
                           const CoupledModel& held,
                           const RigidBody& body);

// How far these least squares miss: the sum over rows of log(scatter^2) of their DOF, a -2 log
// likelihood but for a constant. Lower is nearer; for comparing structures without a fit.
double MomentumMisfit(std::span<const CoupledData> logs,
                      const MotionStructure& structure,
                      const CoupledModel& held);

// Values of a bound that (6) is tried with: of a fin's rate [rad/s], or of the angle at which it
// stalls [rad].
std::span<const double> LimitsTried(const FreeEntry& entry);

}  // namespace fathom
