// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"

#include <optional>
#include <span>

namespace fathom {

// The DOF to look at in a log: `given`, or the only one that log.yaml names. Throws InputError if
// it names none or several.
Dof DofOf(const Log& log, std::optional<Dof> given);

// The same of one or more logs, which have to name the same one.
Dof DofOfAll(std::span<const Log> logs, std::optional<Dof> given);

}  // namespace fathom
