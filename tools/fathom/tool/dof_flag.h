// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <optional>

namespace fathom {

// What --dof says; nothing if it is not given. Throws InputError for what is no DOF.
std::optional<Dof> DofFromFlag();

}  // namespace fathom
