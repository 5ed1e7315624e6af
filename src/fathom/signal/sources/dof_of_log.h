// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"

#include <optional>
#include <span>

namespace fathom {

// The DOF to look at in one log or more: `given`, or the only one that log.yaml names, the same in
// all of them. Throws InputError if one names none or several, or if they name different ones.
Dof DofOfAll(std::span<const Log> logs, std::optional<Dof> given);

}  // namespace fathom
