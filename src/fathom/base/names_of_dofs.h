// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <string>
#include <vector>

namespace fathom {

// "surge, sway and yaw".
std::string NamesOf(const std::vector<Dof>& dofs);

}  // namespace fathom
