// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/store/tables.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fathom {

// Of fewer dives with a usable joint fit nothing is said about change.
inline constexpr std::size_t kFewestDivesForChange = 5;

// Whether DOFs as the tables write them are those of a coupled model: "surge,sway,yaw".
bool IsOfSeveralDofs(const std::string& dofs);

// The DOFs whose changes are those of a coupled model, and not of models of one DOF: those of the
// coupled dive fits of this vehicle that most dives have, where these are five or more, and three
// quarters of the dives that any fit is of. Empty: there are none.
std::string CoupledDofsCompared(const std::vector<DiveFitRow>& dive_fits,
                                const std::string& vehicle);

// Whether the numbers in rows of `dofs` are compared over the dives, `coupled` being as above.
bool AreCompared(const std::string& dofs, const std::string& coupled);

}  // namespace fathom
