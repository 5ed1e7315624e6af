// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

namespace fathom {

// A function file for MATLAB and Octave, xdot = name(x, ui), as the vehicles of the MSS toolbox
// (Marine Systems Simulator) are called, but without need of it. M and D are positive, C is made
// from M. docs/export.md.
//
//   x   u v w p q r, north east down, phi theta psi    [m/s], [rad/s], [m], [rad]
//   ui  the six forces tau                             [N], [N m]
//
// The function's name is ExportTarget::name: the file has to be called so. It fails at theta = +-90
// degrees, as every model by Euler angles does.
ExportedFile MssFunction(const ExportModel& model, const ExportTarget& target);

}  // namespace fathom
