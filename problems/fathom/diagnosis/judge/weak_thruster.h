// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"
#include "fathom/vehicle/thruster.h"

#include <optional>
#include <span>

namespace fathom {

// The thruster whose weakness along its DOF a crosstalk is; nullopt where it is none.
// docs/diagnosis.md (15). `std`: of the crosstalk's gain.
std::optional<WeakThruster> WeakThrusterOf(const ActiveEffect& active,
                                           double std,
                                           std::span<const Thruster> thrusters);

}  // namespace fathom
