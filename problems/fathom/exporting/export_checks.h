// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/coupled_model.h"

#include <string>
#include <vector>

namespace fathom {

// What would make another program's simulation of a model diverge, a sentence each; empty: nothing.
//
//   M   all eigenvalues of its modelled part are above 0
//   C   nu' C(nu) nu = 0 at drawn velocities, to rounding
//   D   without thrust, offset, buoyancy and righting moments, each DOF let go at 0.5 m/s or
//       rad/s: 0.5 nu' M nu never grows, and falls below a half within five of the slowest time
//       constants of the DOFs alone
//   b   from rest, without thrust and offset, nu stays finite over ten of those time constants
//   K   above 0 and above the offset of its DOF, where there is one: at rest the vehicle stays up.
//       That it rests so in the exported file, within 1 degree, HydrostaticsOf() checks.
//
// docs/export.md.
std::vector<std::string> CheckExport(const CoupledModel& model);

// Those that a model has something for: "the inertia", "a free decay".
std::vector<std::string> NamesOfExportChecks(const CoupledModel& model);

}  // namespace fathom
