// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

namespace fathom {

// A robot of Stonefish whose one link is a box: the vehicle's size, scaled to the volume that its
// buoyancy needs, and put where that rights the vehicle. Stonefish computes forces from the shape:
//
//   drag along an axis i   rho S_i Cf_i v + rho/2 A_i Cd_i |v|^2 v
//
//   A_i    area of the box that faces the flow, S_i: area along it   [m^2]
//   Cf_i   viscous_drag [m/s]      Cd_i  quadratic_drag
//
// Its form drag grows with the third power of the speed, and is made equal to D_Q |v| v at
// ExportTarget::matched_speed. docs/export.md.
//
// `problems`: those of SplitInertiaOf() and HydrostaticsOf(), and a damping below 0, with which
// Stonefish ignores all three. Throws InputError as SplitInertiaOf() and RemarksOn() do.
ExportedFile StonefishRobot(const ExportModel& model, const ExportTarget& target);

}  // namespace fathom
