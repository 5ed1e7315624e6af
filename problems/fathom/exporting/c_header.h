// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

namespace fathom {

// One header in C99 that needs <math.h> alone: every number a macro with its unit, interval and
// log; M, C(nu) nu, D(nu) nu, g(eta) and o of docs/coupled.md (1) as functions, the wrench of the
// water, the acceleration, and a step of the classical Runge-Kutta scheme. With a vehicle file that
// has thrusters also B(kappa) T, and their thrust over the pulse width where it has tables of that.
// Names begin with ExportTarget::name. docs/export.md.
//
// Frames and units are ours: docs/notation.md. DOFs that are not modelled keep their velocity.
ExportedFile CHeader(const ExportModel& model, const ExportTarget& target);

}  // namespace fathom
